// What a page draws of the land.

/** Draws the solid land alone, in a picture of `size`. Returns its skyline, the topmost row of land in each column of pixels, the
 *  pixels inside of the land that show none, and the number of triangles. */
export function landSeen(page, size) {
  return page.evaluate(async ({ width, height }) => {
    const { engine } = window.talus;
    const { frames } = engine;
    frames.sky.visible = frames.terrain.liquid.visible = false;
    frames.renderer.setClearColor(0xff00ff, 1);
    const shot = engine.screenshot();
    engine.frame(performance.now()); // the only picture, as software takes long for one
    const picture = await createImageBitmap(await shot);
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext('2d');
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const isLand = (x, y) => data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3).join() !== '255,0,255';
    const skyline = Array.from({ length: width }, (_, x) => {
      let y = 0;
      while (y < height && !isLand(x, y)) ++y;
      return y;
    });
    // From the top row on, from pixel to pixel: what is not reached lies inside.
    const reached = new Uint8Array(width * height);
    const edge = Array.from({ length: width }, (_, x) => [x, 0]);
    while (edge.length > 0) {
      const [x, y] = edge.pop();
      if (x < 0 || x >= width || y < 0 || y >= height || reached[y * width + x] || isLand(x, y)) continue;
      reached[y * width + x] = 1;
      edge.push([x - 1, y], [x + 1, y], [x, y - 1], [x, y + 1]);
    }
    const holes = [];
    for (let y = 0; y < height; ++y) for (let x = 0; x < width; ++x) if (!isLand(x, y) && !reached[y * width + x]) holes.push([x, y]);
    return { skyline, holes, triangles: engine.stats().triangles };
  }, size);
}
