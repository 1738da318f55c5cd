// Bytes, by gzip -9, of the viewer's page and all that it loads before it draws: what the page names, what those import
// at once, and workers. What is imported later, such as the map, does not count.
import { readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { gzipSync } from 'node:zlib';

const folder = process.argv[2];
const seen = new Set();

function visit(path) {
  if (seen.has(path)) return;
  seen.add(path);
  const text = readFileSync(join(folder, path), 'utf8');
  const names = path.endsWith('.html')
    ? [...text.matchAll(/(?:src|href)="(\.\/[^"#]+)"/g)]
    : path.endsWith('.js')
      ? [...text.matchAll(/(?:from|import)\s*"(\.[^"]+)"/g), ...text.matchAll(/new URL\("([^"]+\.js)"/g), ...text.matchAll(/new Worker\("([^"]+)"/g)]
      : [];
  for (const [, name] of names) {
    const found = name.startsWith('/') ? name.slice(1) : normalize(join(dirname(path), name));
    visit(found);
  }
}

visit('index.html');
console.log([...seen].reduce((sum, path) => sum + gzipSync(readFileSync(join(folder, path)), { level: 9 }).length, 0));
