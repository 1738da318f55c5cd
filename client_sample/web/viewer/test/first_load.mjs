// first_load.mjs FOLDER [br]: bytes, by gzip -9 or brotli -q 11, of the viewer's page and all that it loads before it draws: what
// the page names, what those import at once, and workers. What is imported later, such as the map, does not count.
import { readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync, gzipSync } from 'node:zlib';

/** Paths in the folder. */
export function firstLoad(folder) {
  const seen = new Set();
  const visit = (path) => {
    if (seen.has(path)) return;
    seen.add(path);
    const text = readFileSync(join(folder, path), 'utf8');
    const names = path.endsWith('.html')
      ? [...text.matchAll(/(?:src|href)="(\.\/[^"#]+)"/g)]
      : path.endsWith('.js')
        ? [...text.matchAll(/(?:from|import)\s*"(\.[^"]+)"/g), ...text.matchAll(/new URL\("([^"]+\.js)"/g), ...text.matchAll(/new Worker\("([^"]+)"/g)]
        : [];
    for (const [, name] of names) visit(name.startsWith('/') ? name.slice(1) : normalize(join(dirname(path), name)));
  };
  visit('index.html');
  return [...seen];
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [folder, format] = process.argv.slice(2);
  const packed = format === 'br' ? brotliCompressSync : (bytes) => gzipSync(bytes, { level: 9 });
  console.log(firstLoad(folder).reduce((sum, path) => sum + packed(readFileSync(join(folder, path))).length, 0));
}
