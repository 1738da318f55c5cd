// What a page holds, counted after a forced collection.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { stats } from './browser.mjs';

/** Bytes of the heaps of a page's workers. */
async function heapOfWorkers(session) {
  const workers = [];
  const waiting = new Map();
  session.on('Target.attachedToTarget', ({ sessionId }) => workers.push(sessionId));
  session.on('Target.receivedMessageFromTarget', ({ message }) => {
    const { id, result } = JSON.parse(message);
    waiting.get(id)?.(result);
  });
  await session.send('Target.setAutoAttach', { autoAttach: true, waitForDebuggerOnStart: false, flatten: false });
  let calls = 0;
  const call = (sessionId, method) =>
    new Promise((resolve) => {
      const id = ++calls;
      waiting.set(id, resolve);
      void session.send('Target.sendMessageToTarget', { sessionId, message: JSON.stringify({ id, method }) });
    });
  let bytes = 0;
  for (const worker of workers) {
    await call(worker, 'HeapProfiler.enable');
    await call(worker, 'HeapProfiler.collectGarbage');
    const { usedSize, backingStorageSize = 0 } = await call(worker, 'Runtime.getHeapUsage');
    bytes += usedSize + backingStorageSize;
  }
  assert.ok(workers.length >= 2 && bytes > 1e6, `${workers.length} workers hold ${bytes} bytes`);
  return bytes;
}

/** Memory of a process that no file backs, as the kernel counts it. */
const anonymous = (id) => {
  const status = readFileSync(`/proc/${id}/status`, 'utf8');
  return ['RssAnon', 'RssShmem'].reduce((sum, name) => sum + 1024 * Number(new RegExp(`${name}:\\s+(\\d+)`).exec(status)[1]), 0);
};

/** Bytes: `page` and `workers` of JavaScript and its buffers; `renderer` and `graphics` of the processes that they run in and
 *  that draws, of which software keeps there what a card would; `meshes` and `held` as the page itself counts. The cache of
 *  decoded voxels, which has a bound that is reached late, is in `voxels`, and in none of the page's others. */
export async function memory(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.enable');
  await session.send('HeapProfiler.collectGarbage');
  const { usedSize, backingStorageSize = 0 } = await session.send('Runtime.getHeapUsage');
  const workers = await heapOfWorkers(session);
  await session.detach();
  const system = await page.context().browser().newBrowserCDPSession();
  const { processInfo } = await system.send('SystemInfo.getProcessInfo');
  await system.detach();
  const most = (kind) => Math.max(...processInfo.filter(({ type }) => type === kind).map(({ id }) => anonymous(id)));
  const { gpuBytes, heapBytes } = await stats(page);
  const voxels = await page.evaluate(() => window.talus.engine.voxels.bytes);
  return { page: usedSize + backingStorageSize - voxels, workers, voxels, renderer: most('renderer'), graphics: most('GPU'), meshes: gpuBytes, held: heapBytes - voxels };
}
