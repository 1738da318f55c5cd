// A real talusd: $TALUSD, or the newest that is built in this repository.
import { spawn } from 'node:child_process';
import { existsSync, readdirSync, statSync } from 'node:fs';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

const build = fileURLToPath(new URL('../../../../../build', import.meta.url));

/** Its path; undefined: none is built. */
export const talusd =
  process.env.TALUSD ??
  (existsSync(build) ? readdirSync(build) : [])
    .map((preset) => `${build}/${preset}/server/talusd`)
    .filter(existsSync)
    .sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs)[0];

/** Starts one; resolves when it listens. `port` and `httpPort` 0: the system chooses. */
export async function startTalusd({ port = 0, httpPort = 0, args = [], env = {} } = {}) {
  const child = spawn(talusd, ['--listen', `127.0.0.1:${port}`, '--http', `127.0.0.1:${httpPort}`, ...args], {
    env: { ...process.env, ...env },
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  const ended = new Promise((resolve) => child.once('exit', resolve));
  const said = [];
  const server = { child, ended, port, httpPort };
  await new Promise((resolve, reject) => {
    const listen = (line) => {
      said.push(line);
      server.port = Number(/^listening on .*:(\d+)$/.exec(line)?.[1] ?? server.port);
      const http = /^HTTP and WebSocket on .*:(\d+)$/.exec(line);
      if (http === null) return;
      server.httpPort = Number(http[1]);
      resolve();
    };
    for (const stream of [child.stdout, child.stderr]) createInterface({ input: stream }).on('line', listen);
    child.once('error', reject);
    ended.then((code) => reject(new Error(`talusd ended with ${code}:\n${said.join('\n')}`)));
  });
  return {
    ...server,
    urls: {
      tcp: `tcp://127.0.0.1:${server.port}`,
      websocket: `ws://127.0.0.1:${server.httpPort}`,
      http: `http://127.0.0.1:${server.httpPort}`,
    },
    async stop(signal = 'SIGKILL') {
      child.kill(signal);
      await ended;
    },
  };
}
