// Against a real talusd that speaks TLS, with a certificate that nobody vouches for but itself.
import assert from 'node:assert/strict';
import { execFile, execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { startTalusd, talusd } from './support/talusd.js';

const options = { timeout: 120_000, skip: talusd === undefined && 'no talusd is built: build the target talusd, or set TALUSD' };
const program = fileURLToPath(new URL('support/view_hashes.js', import.meta.url));

async function hashesOf(url, trusted) {
  const env = { ...process.env, ...(trusted === null ? {} : { NODE_EXTRA_CA_CERTS: trusted }) };
  return (await promisify(execFile)(process.execPath, [program, url], { env, maxBuffer: 1 << 24 })).stdout;
}

test('the same View by wss, https and tls as without TLS', options, async () => {
  const folder = mkdtempSync(join(tmpdir(), 'talus-js-'));
  after(() => rmSync(folder, { recursive: true }));
  const [key, certificate] = [join(folder, 'key.pem'), join(folder, 'certificate.pem')];
  const name = ['-subj', '/CN=localhost', '-addext', 'subjectAltName=DNS:localhost,IP:127.0.0.1'];
  const kind = ['-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:P-256', '-nodes', '-days', '1'];
  execFileSync('openssl', ['req', '-x509', ...kind, ...name, '-keyout', key, '-out', certificate], { stdio: 'ignore' });

  const open = await startTalusd();
  const plain = await hashesOf(open.urls.tcp, null);
  await open.stop('SIGTERM');
  assert.ok(Object.keys(JSON.parse(plain)).length > 125);

  const secure = await startTalusd({ env: { TALUS_TLS_CERTIFICATE: certificate, TALUS_TLS_KEY: key } });
  const urls = [`wss://localhost:${secure.httpPort}`, `https://localhost:${secure.httpPort}`, `tls://localhost:${secure.port}`];
  for (const url of urls) {
    assert.equal(await hashesOf(url, certificate), plain, url);
    assert.match(await hashesOf(url, null), /^unreachable: /, `${url}, by who does not trust the certificate`);
  }
  await secure.stop('SIGTERM');
});
