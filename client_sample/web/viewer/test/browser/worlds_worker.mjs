import { goldenText } from '/golden_text.mjs';
import { World } from '/wasm/world.js';

onmessage = async ({ data: simd }) => {
  try {
    let set;
    const open = async (toml, files) => {
      const world = await World.open(toml, { files, simd });
      set = world.instructionSet;
      return world;
    };
    postMessage({ text: await goldenText(open, await (await fetch('/inputs.json')).json()), set });
  } catch (error) {
    postMessage({ failure: String(error.stack) });
  }
};
