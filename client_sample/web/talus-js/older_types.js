// dist/ts5.0: the declarations for TypeScript before 5.7, whose typed arrays have no parameter.
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

const folder = 'dist/ts5.0';
rmSync(folder, { recursive: true, force: true });
for (const file of readdirSync('dist', { recursive: true })) {
  if (!file.endsWith('.d.ts')) continue;
  mkdirSync(dirname(join(folder, file)), { recursive: true });
  const text = readFileSync(join('dist', file), 'utf8');
  writeFileSync(join(folder, file), text.replace(/\b([A-Z]\w*Array)<ArrayBuffer(Like)?>/g, '$1').replaceAll("'../../wasm/", "'../../../wasm/"));
}
