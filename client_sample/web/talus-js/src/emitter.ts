// Named events. A handler may add and remove handlers. An exception of a handler is the application's error: it is
// rethrown outside this package's calls, and the other handlers still run.

type Handlers = Record<string, (...args: never[]) => void>;

export class Emitter<Events extends { [K in keyof Events]: (...args: never[]) => void }> {
  private readonly handlers = new Map<keyof Events, readonly Handlers[string][]>();

  on<K extends keyof Events>(event: K, handler: Events[K]): void {
    this.handlers.set(event, [...(this.handlers.get(event) ?? []), handler]);
  }

  off<K extends keyof Events>(event: K, handler: Events[K]): void {
    this.handlers.set(event, (this.handlers.get(event) ?? []).filter((each) => each !== handler));
  }

  emit<K extends keyof Events>(event: K, ...args: Parameters<Events[K]>): void {
    for (const handler of this.handlers.get(event) ?? []) {
      try {
        handler(...(args as never[]));
      } catch (error) {
        queueMicrotask(() => {
          throw error;
        });
      }
    }
  }
}
