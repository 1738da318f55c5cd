// A real talusd for a test: on free ports of its own, ended with the test.
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { serve } from './site.mjs';

const program = process.env.TALUSD ?? missing('TALUSD');
const generator = process.env.TALUS_GEN ?? missing('TALUS_GEN');
export const DIST = process.env.VIEWER_DIST ?? fileURLToPath(new URL('../../dist', import.meta.url));

function missing(name) {
  throw new Error(`${name} is not set: the path of the program; test/browser/run.sh sets it`);
}

const servesFiles = execFileSync(program, ['--help'], { encoding: 'utf8' }).includes('--web ');

/** A folder that goes with the test. */
export function scratch(t) {
  const folder = mkdtempSync(join(tmpdir(), 'talus-browser-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** A certificate for 127.0.0.1 that vouches for itself: flags of a talusd that speaks TLS. */
export function tlsFlags(t) {
  const folder = scratch(t);
  const [key, certificate] = [`${folder}/key.pem`, `${folder}/certificate.pem`];
  const of = ['-subj', '/CN=localhost', '-addext', 'subjectAltName=DNS:localhost,IP:127.0.0.1'];
  execFileSync('openssl', ['req', '-x509', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:P-256', '-nodes', '-days', '1', ...of, '-keyout', key, '-out', certificate], { stdio: 'ignore' });
  writeFileSync(`${folder}/talusd.toml`, `[tls]\ncertificate = "${certificate}"\nkey = "${key}"\n`);
  return ['--config', `${folder}/talusd.toml`];
}

/** Resolves when it listens: { http: 'HOST:PORT', stop, kill }. */
export async function startTalusd({ http = '127.0.0.1:0', args = [] } = {}) {
  const web = servesFiles ? ['--web', DIST] : [];
  const child = spawn(program, ['--listen', '127.0.0.1:0', '--http', http, ...web, ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = new Promise((resolve) => child.once('exit', resolve));
  let said = '';
  const address = await new Promise((resolve, reject) => {
    const read = (bytes) => {
      said += bytes;
      const found = /HTTP and WebSocket on https?:\/\/(\S+)/.exec(said);
      if (found) resolve(found[1].replace(/[,;]$/, '').replace(/\/$/, ''));
    };
    child.stdout.on('data', read);
    child.stderr.on('data', read);
    ended.then(() => reject(new Error(`talusd did not start: ${said}`)));
  });
  const end = (signal) => async () => {
    child.kill(signal);
    await ended;
  };
  return { http: address, stop: end('SIGTERM'), kill: end('SIGKILL') };
}

/** A talusd with the viewer before it: { url, talusd, restart(args) } on an address that stays. */
export async function startSite(t, args = []) {
  const site = { talusd: await startTalusd({ args }) };
  t.after(() => site.talusd.stop());
  if (servesFiles) {
    site.url = `http://${site.talusd.http}/`;
  } else {
    const front = await serve(DIST, () => site.talusd.http);
    t.after(() => front.close());
    site.url = front.url;
  }
  site.restart = async (newArgs = args) => {
    site.talusd = await startTalusd({ http: site.talusd.http, args: newArgs });
  };
  return site;
}

export function talusGen(...args) {
  return execFileSync(generator, args, { encoding: 'utf8' });
}
