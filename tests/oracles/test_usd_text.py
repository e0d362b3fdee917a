"""Text layers: every notation that OpenUSD reads, in layers that OpenUSD itself reads first."""

import random

import numpy as np
import pytest
from pxr import Sdf, Usd, UsdGeom

from usd_scenes import compare, expected

pytestmark = pytest.mark.skipif(Usd.GetVersion() < (0, 26, 11), reason="the notations are those of OpenUSD 26.11")

HEAD = "#usda 1.0\n(\n    metersPerUnit = 1\n)\n"
MESH = """def Mesh "Seen"
{
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
    uniform token subdivisionScheme = "none"
    double3 xformOp:translate = (1, 2, 3)
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
"""

PROPERTIES = [
    "bool a = yes", "bool a = TRUE", "bool a = 1.0", "bool a.timeSamples = {1: true, 2: 0}",
    "int a = 1.7", "uint a = 3", "uint[] a = [1, 2]", "uint64[] a = [18446744073709551615]", "int64[] a = [-1]",
    "uchar[] a = [255]", "half[] a = [1.5, -inf]", "float a = nan", "float a = -inf", "float a = 1.e5",
    "float a = .5e-3", "float a = -.5", "double a = 1.", "timecode[] a = [1, 2]", "bool[] a = [true, 0, no]",
    "string[] a = ['x', \"y\"]", "asset a = \"x.png\"", "asset[] a = [@x@, \"y\"]",
    "asset a.timeSamples = { 1: @a1.png@, 2: @a2.png@, 3: None }", "asset a = @@@x@y@@@", "asset a = @@@x\\@@@y@@@",
    "asset a = @@", "Foo a = 3", "Foo[] a = [(1, 2)]", "Foo a.timeSamples = {1: 2}", "Foo a", "group a", "opaque a",
    "pathExpression a = \"/Box//\"", "pathExpression[] a = [\"/a\", \"/b\"]", "pathExpression a = None",
    "matrix2d a = ((1, 2), (3, 4),)", "matrix3d[] a = [((1,0,0),(0,1,0),(0,0,1))]", "float3 a = (1, 2, 3,)",
    "int[] a = [[1, 2], [3, 4]]", "float3[] a = []", "float3[] a = None", "float a = AnimationBlock",
    "float a.timeSamples = {}", "float a.timeSamples = {2: 1, 1: 2, 1: 3,}", "float a.timeSamples = {-1.5: 1}",
    "float a.timeSamples = {inf: 1}", "double a.spline = {\nbezier,\n1: 2; post held,\n}",
    "Vec3f[] a = [(1, 2, 3)]", "Point a = (1, 2, 3)", "PointFloat[] a = [(1, 2, 3)]", "PointIndex[] a = [1]",
    "EdgeIndex a = 1", "FaceIndex a = 1", "ColorFloat a = (1, 1, 1)", "Normal a = (0, 0, 1)", "Quatf a = (1, 0, 0, 0)",
    "Transform a = ((1,0,0,0),(0,1,0,0),(0,0,1,0),(0,0,0,1))", "Frame a = ((1,0,0,0),(0,1,0,0),(0,0,1,0),(0,0,0,1))",
    "float a = 1 (foo = (1, 2))", "float a = 1 (foo = [1, 2])", "float a = 1 (foo = </A>)", "float a = 1 (foo = @a@)",
    "float a = 1 (foo = {int x = 3})", "float a = 1 (foo = bar)", "float a = 1 (elementSize = 3.0)",
    "float a = 1 (\"comment\"; doc = 'x')", "float a = 1; float b = 2", "float a:b:c = 1", "float def = 1",
    "float rel = 1", "float timeSamples = 1", "float uniform = 1", "float é = 1", "float 日本 = 1",
    "config float a = 1", "custom uniform float a = 1", "float [ ] a = [1]", "float a.connect = </A.b>",
    "float a.connect = [</A.b>, <../C.d>]", "float a.connect = None", "prepend float a.connect = <.b>",
    "rel a", "rel a = None", "rel a = []", "prepend rel a = [</A>, </B>,]", "custom varying rel a = <../X>",
    "rel a.default = </A>", "rel a = </A.b[/C.d].e>", "rel a = </A> (bindMaterialAs = \"x\")",
    "string a = \"\"\"x\ny\"\"\"", "string a = ''", "string a = '''it's'''", "reorder properties = [\"a\", \"b\"]",
    "reorder nameChildren = \"x\"", "variantSet \"v\" = {\n\"x|y-1\" (kind = 'y') {\nfloat a = 1\n}\n\".z\" {}\n}",
    "variantSet \"v\" = {}", "def É.X::Y \"Inner\" {\n}", "float a = 1 // C++ comment", "/* block\ncomment */ float a = 1",
    "float a = /* inside */ 1", "# shell comment", "float a = 1\r\nfloat b = 2",
]  # fmt: skip

PRIM_METADATA = [
    "active = 1", "active = \"true\"", "apiSchemas = None", "prepend apiSchemas = [\"A\"]\nappend apiSchemas = [\"B\"]",
    "references = None", "references = []", "references = <>", "payload = None", "inherits = <../Other>",
    "variants = {string \"b c\" = \"x\"; string d = 'y'}", "add variantSets = [\"a\"]", "delete variantSets = \"a\"",
    "permission = public", "symmetryFunction = mirror", "symmetryArguments = {string a = 'x'}", "prefix = 'x'",
    "prepend foo = [\"a\"]", "inactiveIds = [1, 2]", "prepend inactiveIds = [1]", "prepend clipSets = ['a']",
    "foo = None", "foo = [[1, 2], [3]]", "foo = {dictionary a = {int[] b = [1, 2]}}", "\"only a comment\"",
    "assetInfo = {asset identifier = @a@}", "customData = {\nint def = 3; pathExpression x = '/x'\n}",
    "displayGroupOrder = ['a']", "sdrMetadata = {string a = 'b'}", "hidden = true",
]  # fmt: skip

LAYERS = [
    "#usda 1.0", "#usda 1.1", "#usda 1.0 written by hand", "#usda 1.0\n()",
    "#usda 1.0\n(\"a comment\"\ndoc = 'x'; upAxis = 'Z'\n)", "#usda 1.0\n(foo = 3)", "#usda 1.0\n(metersPerUnit = 1)",
    "#usda 1.0\n(subLayers = [])", "#usda 1.0\n(defaultPrim = '/A/B')", "#usda 1.0\n(colorConfiguration = @a@)",
    "#usda 1.0\n(relocates = {</A/B>: </A/C>})", "#usda 1.0\n(expressionVariables = {string a = 'x'})",
    "#usda 1.0\n(customLayerData = {string[] a = ['x']; asset b = @x@})", "#usda 1.0 // comment\n/* another */",
]  # fmt: skip


def agrees(tmp_path, scene_dump, text: str):
    path = tmp_path / "layer.usda"
    path.write_text(text, newline="")
    stage = Usd.Stage.Open(str(path))
    compare(scene_dump(path), expected(stage))
    return stage


@pytest.mark.parametrize("line", PROPERTIES)
def test_every_notation_of_properties_is_read(tmp_path, scene_dump, line):
    agrees(tmp_path, scene_dump, f'{HEAD}def "Before"\n{{\n{line}\n}}\n{MESH}')


@pytest.mark.parametrize("line", PRIM_METADATA)
def test_every_notation_of_metadata_is_read(tmp_path, scene_dump, line):
    agrees(tmp_path, scene_dump, f'{HEAD}def "Before" (\n{line}\n)\n{{\n}}\n{MESH}')


@pytest.mark.parametrize("head", LAYERS)
def test_every_header_is_read(tmp_path, scene_dump, head):
    agrees(tmp_path, scene_dump, f"{head}\n{MESH}")


def test_a_reference_to_any_text_keeps_its_content(tmp_path, scene_dump):
    (tmp_path / "inner.usda").write_text(HEAD + MESH.replace("{\n", "{\n    uint[] ids = [1] // ids\n", 1))
    stage = agrees(tmp_path, scene_dump, f'{HEAD}def "A" (prepend references = @./inner.usda@</Seen>)\n{{\n}}\n')
    assert stage.GetPrimAtPath("/A").IsA(UsdGeom.Mesh)


class Writer:
    """Writes values in random notations, white space and comments."""

    def __init__(self, seed: int):
        self.random = random.Random(seed)

    def number(self, value: float) -> str:
        texts = [repr(value), f"{value:.17e}", f"{value:.17g}"]
        if value == int(value):
            texts += [f"{int(value)}", f"{int(value)}.", f"{int(value)}.0", f"{int(value)}e0", f"{int(value)}.E+0"]
        if 0 < abs(value) < 1:
            plain = f"{value:.20f}".rstrip("0")
            texts += [plain.replace("0.", ".", 1)]
        return self.random.choice(texts)

    def space(self) -> str:
        return self.random.choice(["", "", " ", "  ", "\t", " /* x */ "])

    def line(self) -> str:
        return self.random.choice(["\n", "\n\n", " # end\n", " // end\n", "\n/* a\nb */\n", ";\n", "\r\n"])

    def tuple(self, values) -> str:
        comma = self.random.choice(["", ","])
        return "(" + f",{self.space()} ".join(self.number(float(v)) for v in values) + comma + ")"

    def list(self, items) -> str:
        items = list(items)
        comma = self.random.choice(["", ","]) if items else ""
        break_after = self.random.choice(["", " ", "\n"])
        return f"[{break_after}" + f",{self.space()}{break_after}".join(items) + comma + break_after + "]"

    def mesh(self, name: str) -> str:
        draw = self.random
        points = [[draw.choice([0.5, -0.25, 1.0, 2.0, -3.0, 1e-7, draw.uniform(-2, 2)]) for _ in range(3)] for _ in range(6)]
        kind = draw.choice(["point3f", "Vec3f", "float3", "PointFloat", "point3d", "double3", "half3"])
        index = draw.choice(["int", "PointIndex"])
        lines = [
            f"{index}[] faceVertexCounts{self.space()}={self.space()}[3, 3]",
            f"int[] faceVertexIndices = {self.list(map(str, range(6)))}",
            f"{kind}[] points = {self.list(map(self.tuple, points))}",
            'uniform token subdivisionScheme = "none"',
            f"color3f[] primvars:displayColor = {self.list([self.tuple([0.5, 1, 0.25])])}"
            + draw.choice(["", ' (interpolation = "constant")', '(\n"c"\ninterpolation = \'constant\'\nfoo = [1, "x"]\n)']),
            f"{draw.choice(['double3', 'float3', 'half3', 'Vec3d'])} xformOp:translate = {self.tuple([1, -0.5, 2])}",
            f"float xformOp:rotateX = {self.number(draw.choice([0.5, 30.0, -0.125]))}",
            'uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateX"]',
            draw.choice(PROPERTIES[:60]).replace(" a", " custom_a"),
        ]
        # In one prim an order of properties changes nothing.
        draw.shuffle(lines)
        body = "".join(f"    {line}{self.line()}" for line in lines)
        metadata = draw.choice(["", "(\n" + draw.choice(['kind = "component"', 'doc = """a\n(b"""', "foo = {}"]) + "\n) "])
        return f'def Mesh "{name}" {metadata}{{\n{body}}}\n'

    def layer(self) -> str:
        return HEAD + "\n".join(self.mesh(f"M{at}") for at in range(4))


@pytest.mark.parametrize("seed", range(40))
def test_random_notations_have_openusds_values(tmp_path, scene_dump, seed):
    text = Writer(seed).layer()
    stage = agrees(tmp_path, scene_dump, text)
    assert len(expected(stage)) == 4, "OpenUSD reads what is written"


def test_numbers_are_openusds_to_the_bit(tmp_path, scene_dump):
    rng = np.random.default_rng(0)
    numbers = np.concatenate([rng.uniform(-1, 1, 3000) * 10.0 ** rng.integers(-30, 30, 3000), [0.1, 1 / 3, 16777217.0]])
    # Texts that lie between two single-precision numbers are rounded twice.
    texts = [f"{number:.{digits}g}" for number in numbers for digits in (9, 17, 25)]
    texts = texts[: len(texts) // 3 * 3]
    points = [f"({', '.join(texts[at : at + 3])})" for at in range(0, len(texts), 3)]
    count = len(points)
    path = tmp_path / "numbers.usda"
    path.write_text(
        f'{HEAD}def Mesh "M"\n{{\n int[] faceVertexCounts = [{", ".join(["3"] * (count // 3))}]\n'
        f" int[] faceVertexIndices = {list(range(count // 3 * 3))}\n point3f[] points = [{', '.join(points)}]\n"
        ' uniform token subdivisionScheme = "none"\n}\n'
    )
    layer = Sdf.Layer.FindOrOpen(str(path))
    wanted = np.asarray(layer.GetAttributeAtPath("/M.points").default)
    dump = scene_dump(path)
    got = dump.array(dump.scene["meshes"][0]["positions"])
    np.testing.assert_array_equal(got.view(np.uint32), wanted.astype(np.float32).view(np.uint32))
