import {
  BoxGeometry, BufferGeometry, Color, DoubleSide, EdgesGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineLoop,
  LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, type Object3D,
} from "three";
import { type Rgb, css } from "../gpu/colormaps";
import type { Mesh as WireMesh } from "../net/wire";
import type { DepthSensor, Model, Pose } from "../protocol";
import { makeMesh } from "./meshes";

/** What of an OAK is drawn. */
export interface OakLook {
  model: Model;
  sensor: DepthSensor | undefined;
  /** The mesh of the body; a box until it is loaded, or if there is none. */
  body: WireMesh | null;
  color: Rgb;
  isSelected: boolean;
  showCameras: boolean;
  showRanges: boolean;
}

/** The length of the frusta of cameras, metres. */
const CAMERA_DEPTH = 0.25;
/** A frustum that is wider than this is cut: it would have no end. */
const MAX_FOV_DEG = 150;
const RANGE_COLORS = { minimum: "#e5484d", ideal: "#2fa36b", maximum: "#d9822b" };

/** Draws an OAK in its body frame. */
export function makeOak(look: OakLook): Group {
  const group = new Group();
  group.add(makeBody(look));
  if (look.showCameras) {
    for (const camera of look.model.cameras) {
      const { hfovDeg, vfovDeg, bodyFromCamera } = camera;
      const lines = frustum(hfovDeg, vfovDeg, CAMERA_DEPTH, css(look.color), look.isSelected ? 0.9 : 0.45);
      group.add(placed(lines, bodyFromCamera));
    }
  }
  if (look.showRanges && look.sensor) group.add(placed(makeRanges(look.sensor, look), look.sensor.bodyFromCamera));
  return group;
}

/** Frees what a group holds on the graphics card. */
export function dispose(root: Object3D): void {
  root.traverse((object) => {
    const { geometry, material } = object as Partial<Mesh>;
    geometry?.dispose();
    for (const one of Array.isArray(material) ? material : [material]) one?.dispose();
  });
}

export function place(object: Object3D, pose: Pose): void {
  object.position.set(...pose.position);
  object.quaternion.set(...pose.quaternion);
  object.updateMatrixWorld(true);
}

/** Returns the matrix of a row-major 3 × 4 transform. */
export function matrix(rows: number[]): Matrix4 {
  const [a = 1, b = 0, c = 0, d = 0, e = 0, f = 1, g = 0, h = 0, i = 0, j = 0, k = 1, l = 0] = rows;
  return new Matrix4().set(a, b, c, d, e, f, g, h, i, j, k, l, 0, 0, 0, 1);
}

function placed(object: Object3D, rows: number[]): Object3D {
  object.applyMatrix4(matrix(rows));
  return object;
}

function makeBody({ model, body, color, isSelected }: OakLook): Object3D {
  const { size, centre } = model.body;
  const group = new Group();
  const box = new BoxGeometry(...size);
  if (body) group.add(makeMesh(body, false));
  else group.add(new Mesh(box, new MeshLambertMaterial({ color: "#5b6470" })));
  const outline = new LineSegments(new EdgesGeometry(box), new LineBasicMaterial({ color: css(color), transparent: !isSelected, opacity: isSelected ? 1 : 0.6 }));
  // A mesh has its place in the body frame; boxes are made about their centre.
  for (const child of body ? [outline] : [...group.children, outline]) child.position.set(...centre);
  group.add(outline);
  return group;
}

/** Returns half the width and height of a frustum at a distance. */
function halfSize(hfovDeg: number, vfovDeg: number, depth: number): [number, number] {
  const half = (degrees: number) => Math.tan((Math.min(degrees, MAX_FOV_DEG) * Math.PI) / 360) * depth;
  return [half(hfovDeg), half(vfovDeg)];
}

function corners(hfovDeg: number, vfovDeg: number, depth: number): [number, number, number][] {
  const [x, y] = halfSize(hfovDeg, vfovDeg, depth);
  return [[-x, -y, depth], [x, -y, depth], [x, y, depth], [-x, y, depth]];
}

/** Draws the edges of a frustum in an optical frame. */
function frustum(hfovDeg: number, vfovDeg: number, depth: number, color: string, opacity: number): LineSegments {
  const points = corners(hfovDeg, vfovDeg, depth);
  const segments = points.flatMap((point, i) => [[0, 0, 0], point, point, points[(i + 1) % 4] as number[]]);
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(segments.flat(), 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color: new Color(color), transparent: true, opacity }));
}

/** Draws the frustum of a depth sensor with planes at the minimum, ideal and maximum distance: depth is measured along the axis. */
function makeRanges(sensor: DepthSensor, { color, isSelected }: OakLook): Group {
  const group = new Group();
  const { hfovDeg, vfovDeg, minimumM, idealM, maximumM } = sensor;
  const end = idealM?.[1] ?? maximumM ?? 3;
  group.add(frustum(hfovDeg, vfovDeg, end, css(color), isSelected ? 0.55 : 0.25));
  const planes: [number | null, string][] = [
    [minimumM, RANGE_COLORS.minimum],
    [idealM?.[0] ?? null, RANGE_COLORS.ideal],
    [idealM?.[1] ?? null, RANGE_COLORS.ideal],
    [maximumM, RANGE_COLORS.maximum],
  ];
  if (isSelected) {
    for (const [depth, planeColor] of planes) if (depth !== null && depth > 0) group.add(...rangePlane(hfovDeg, vfovDeg, depth, planeColor));
  }
  return group;
}

function rangePlane(hfovDeg: number, vfovDeg: number, depth: number, color: string): Object3D[] {
  const points = corners(hfovDeg, vfovDeg, depth);
  const outline = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points.flat(), 3));
  const face = outline.clone().setIndex([0, 1, 2, 0, 2, 3]);
  const fill = new MeshBasicMaterial({ color, transparent: true, opacity: 0.05, side: DoubleSide, depthWrite: false });
  return [new LineLoop(outline, new LineBasicMaterial({ color })), new Mesh(face, fill)];
}
