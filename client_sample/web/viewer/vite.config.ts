import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

// Where `npm run dev` finds a talusd: its --http address.
const server = process.env.TALUS_HTTP ?? 'http://127.0.0.1:4781';

export default defineConfig({
  base: './',
  resolve: {
    alias: [
      { find: /^talus$/, replacement: here('../talus-js/src/index.ts') },
      { find: /^talus\/local$/, replacement: here('../talus-js/src/local/index.ts') },
    ],
    dedupe: ['flatbuffers'],
  },
  worker: { format: 'es' },
  build: {
    target: 'es2022',
    // The content security policy allows no data: URL but for pictures, and no inline script.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    sourcemap: false,
    // three.js is most of it.
    chunkSizeWarningLimit: 900,
    rollupOptions: { input: { index: here('index.html'), map: here('map.html') } },
  },
  server: { proxy: { '/v1': { target: server, ws: true, changeOrigin: true } } },
  test: { include: ['test/unit/**/*.test.ts'] },
});
