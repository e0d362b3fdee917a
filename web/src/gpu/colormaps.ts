/** A colour, each part from 0 to 255. */
export type Rgb = readonly [number, number, number];

export type DepthMap = "viridis" | "cividis" | "turbo" | "grey";

export const DEPTH_MAPS: { map: DepthMap; title: string }[] = [
  { map: "viridis", title: "Viridis" },
  { map: "cividis", title: "Cividis" },
  { map: "turbo", title: "Turbo (not colour-blind safe)" },
  { map: "grey", title: "Grey" },
];

/** Colours at equal distances, as hexadecimal digits: 33 samples of Matplotlib's maps of the same name. */
const SAMPLES: Record<DepthMap, string> = {
  viridis:
    "440154470d6048186a482374472d7b4537814240863e49893b528b375b8d33638d2f6b8e2c728e297a8e26828e23898e21918c1f988b1fa08822a785" +
    "28ae8032b67a3fbc734ec36b5ec96270cf5784d44b98d83eaddc30c2df23d8e219ece51bfde725",
  cividis:
    "00224e00285b002e6a0533711a386f273e6e32436d3b496c434e6c4b546c535a6d5a5f6e61656f686a716f70737676767d7c788482798c8878938e78" +
    "9b9476a39a74aba072b4a76fbcae6cc4b468cdbb63d5c25edec958e7d150f0d846f9e03afee838",
  turbo:
    "30123b392a734040a24456c7466be34680f64294ff37a8fa28bceb1ccdd818ddc21fe9af32f2984ef97d6dfe628bff4ba4fc3cb9f635cdec34dfdf37" +
    "eecf3af8be39fdac34fe962bfb7e21f46617eb500edf3f08d02f05be2102a91601920b017a0403",
  grey: "0a0a0affffff",
};

/** Blue for too near, orange for too far: the two differ in hue for every kind of colour blindness, and in nothing at zero. */
const DIVERGING = "08306b2171b56baed6c6dbeff2f0ecfdd0a2f1914ecc4c02702a04";

/** The number of colours of a table. */
export const TABLE_SIZE = 256;

function parse(samples: string): Rgb[] {
  return (samples.match(/.{6}/g) ?? []).map((hex) => {
    const value = Number.parseInt(hex, 16);
    return [value >> 16, (value >> 8) & 255, value & 255];
  });
}

/** Interpolates samples to RGBA bytes. */
function table(samples: Rgb[]): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(TABLE_SIZE * 4);
  for (let i = 0; i < TABLE_SIZE; i++) {
    const place = (i / (TABLE_SIZE - 1)) * (samples.length - 1);
    const index = Math.min(Math.floor(place), samples.length - 2);
    const [before, after] = [samples[index] as Rgb, samples[index + 1] as Rgb];
    const mix = (channel: 0 | 1 | 2) => before[channel] + (after[channel] - before[channel]) * (place - index);
    bytes.set([mix(0), mix(1), mix(2), 255], i * 4);
  }
  return bytes;
}

const tables = new Map<string, Uint8Array<ArrayBuffer>>();

function remembered(samples: string): Uint8Array<ArrayBuffer> {
  const known = tables.get(samples) ?? table(parse(samples));
  tables.set(samples, known);
  return known;
}

export function depthTable(map: DepthMap): Uint8Array<ArrayBuffer> {
  return remembered(SAMPLES[map]);
}

export function errorTable(): Uint8Array<ArrayBuffer> {
  return remembered(DIVERGING);
}

/** The codes from this one on are those of filters, which have the last colours. */
const FIRST_FILTER = 32;
const FILTER_COLORS = 7;

/**
 * The colours of reasons. Code 0, a measured pixel, recedes; neighbours differ in lightness as well as in hue, because there
 * are more reasons than hues that everybody can tell apart. The legend and the readout name them.
 */
const REASON_COLORS: Rgb[] = parse(
  "3a4048" + "0b0d10" + "e69f00" + "56b4e9" + "f0e442" + "0072b2" + "d55e00" + "ffffff" + "cc79a7" + "999999" + "009e73" + "882255" +
    "aa4499" + "ddcc77" + "117733" + "88ccee" + "332288" + "cc6677" + "44aa99" + "b0724a" + "7f7fff" + "c8e6a0",
);

export function reasonColor(code: number): Rgb {
  const own = REASON_COLORS.length - FILTER_COLORS;
  const place = code < FIRST_FILTER ? code % own : own + ((code - FIRST_FILTER) % FILTER_COLORS);
  return REASON_COLORS[place] as Rgb;
}

export function reasonTable(): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(TABLE_SIZE * 4);
  for (let code = 0; code < TABLE_SIZE; code++) bytes.set([...reasonColor(code), 255], code * 4);
  return bytes;
}

/** The codes from this one on are those of points of surfaces that no pixel shows, and of such without a reason. */
const FIRST_OUTCOME = 127;
/** Of points that are not measured for no known reason, not resolved, hidden, facing away and outside the view. */
const OUTCOME_COLORS: Rgb[] = parse("7a5195" + "b9a44c" + "4a5f8a" + "7f858d" + "b9c0c9");
const MEASURED_COLOR: Rgb = [47, 163, 107];

/** The colour of what became of a point of a surface. */
export function outcomeColor(code: number): Rgb {
  if (code === 0) return MEASURED_COLOR;
  return code < FIRST_OUTCOME ? reasonColor(code) : (OUTCOME_COLORS[(code - FIRST_OUTCOME) % OUTCOME_COLORS.length] as Rgb);
}

export function css([red, green, blue]: Rgb): string {
  return `rgb(${red}, ${green}, ${blue})`;
}

/** The colours that tell OAKs apart, for frusta, dots and lines: their contrast is at least 3 : 1 in both themes. */
const OAK_COLORS: Rgb[] = parse("2f7fd0c47f001d8f66c04f00b0578c7a5fe0");

export function oakColor(index: number): Rgb {
  return OAK_COLORS[index % OAK_COLORS.length] as Rgb;
}
