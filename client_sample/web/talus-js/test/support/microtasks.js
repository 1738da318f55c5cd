/** From now on: what microtasks throw, which would end the process. */
export function catchMicrotasks(t) {
  const thrown = [];
  const queue = globalThis.queueMicrotask;
  t.mock.method(globalThis, 'queueMicrotask', (task) =>
    queue(() => {
      try {
        task();
      } catch (error) {
        thrown.push(error);
      }
    }),
  );
  return thrown;
}
