// Reads manifests and holds them against Kubernetes' own types, as the package kubernetes-models has them.
import { readFileSync, readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseAllDocuments } from 'yaml';

const require = createRequire(import.meta.url);
export const root = join(dirname(fileURLToPath(import.meta.url)), '../../..');

export function documents(path) {
  return parseAllDocuments(readFileSync(join(root, path), 'utf8')).map((document) => {
    if (document.errors.length > 0) throw new Error(`${path}: ${document.errors[0].message}`);
    return document.toJS();
  });
}

export function filesBelow(folder) {
  return readdirSync(join(root, folder), { recursive: true })
    .filter((name) => name.endsWith('.yaml'))
    .map((name) => join(folder, name))
    .sort();
}

function validator({ apiVersion, kind }) {
  const [group, version] = apiVersion.includes('/') ? apiVersion.split('/') : ['core', apiVersion];
  const upper = (word) => word[0].toUpperCase() + word.slice(1);
  const name = `IoK8sApi${upper(group.split('.')[0])}${upper(version)}${kind}`;
  const folder = dirname(require.resolve('kubernetes-models/package.json'));
  return require(join(folder, '_schemas', `${name}.js`)).validate;
}

// The package's types let unknown keys pass. But they look at every key that they know: one that nobody looked at is unknown.
function watched(value, path, seen) {
  if (typeof value !== 'object' || value === null) return value;
  const looked = new Set();
  let walked = false;
  const copy = Array.isArray(value) ? [] : {};
  for (const key of Object.keys(value)) copy[key] = watched(value[key], `${path}/${key}`, seen);
  if (!Array.isArray(value)) seen.push({ path, keys: Object.keys(value), looked, walked: () => walked });
  return new Proxy(copy, {
    get(target, key) {
      looked.add(key);
      return target[key];
    },
    ownKeys(target) {
      walked = true;
      return Reflect.ownKeys(target);
    },
  });
}

/** What is wrong with a manifest, a line each. */
export function faults(manifest) {
  const check = validator(manifest);
  const lines = [];
  if (!check(manifest)) lines.push(...check.errors.map((error) => `${error.instancePath}: ${error.keyword} ${JSON.stringify(error.params)}`));
  const seen = [];
  check(watched(manifest, '', seen));
  for (const { path, keys, looked, walked } of seen) {
    // A map, whose keys are the author's, is walked; one that its type leaves open is not looked into at all.
    if (walked() || looked.size === 0) continue;
    for (const key of keys) if (!looked.has(key)) lines.push(`${path}/${key}: unknown`);
  }
  return lines;
}
