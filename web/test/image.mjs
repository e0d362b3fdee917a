// Reads pictures and compares them: the browser decodes and scales them.

/** Returns the pixels of a PNG, RGBA, scaled to a width. */
export async function read(page, png, width) {
  const { data, ...size } = await page.evaluate(async ([text, width]) => {
    const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const scale = (width ?? bitmap.width) / bitmap.width;
    const canvas = new OffscreenCanvas(Math.round(bitmap.width * scale), Math.round(bitmap.height * scale));
    const context = canvas.getContext("2d");
    context.imageSmoothingQuality = "high";
    context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    let binary = "";
    for (let i = 0; i < data.length; i += 0x8000) binary += String.fromCharCode(...data.subarray(i, i + 0x8000));
    return { width: canvas.width, height: canvas.height, data: btoa(binary) };
  }, [png.toString("base64"), width ?? null]);
  return { ...size, data: Buffer.from(data, "base64") };
}

/** Returns a PNG, or a picture of another type, scaled to a width. */
export async function scaled(page, png, width, type = "image/png") {
  const text = await page.evaluate(async ([text, width, type]) => {
    const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const canvas = new OffscreenCanvas(width, Math.round((bitmap.height * width) / bitmap.width));
    const context = canvas.getContext("2d");
    context.imageSmoothingQuality = "high";
    context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
    const made = new Uint8Array(await (await canvas.convertToBlob({ type, quality: 0.82 })).arrayBuffer());
    let binary = "";
    for (let i = 0; i < made.length; i += 0x8000) binary += String.fromCharCode(...made.subarray(i, i + 0x8000));
    return btoa(binary);
  }, [png.toString("base64"), width, type]);
  return Buffer.from(text, "base64");
}

/** Returns how much two pictures of one size differ: the mean over all pixels, and the share of pixels that differ by more than `far`. */
export function difference(a, b, far) {
  if (a.width !== b.width || a.height !== b.height) return { mean: 255, share: 1 };
  const count = a.width * a.height;
  let [sum, distant] = [0, 0];
  for (let i = 0; i < count; i++) {
    let most = 0;
    for (let channel = 0; channel < 3; channel++) most = Math.max(most, Math.abs(a.data[i * 4 + channel] - b.data[i * 4 + channel]));
    sum += most;
    if (most > far) distant++;
  }
  return { mean: sum / count, share: distant / count };
}
