// Events by name. A handler may add and remove handlers; what it throws goes to the caller of emit().

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
    for (const handler of this.handlers.get(event) ?? []) handler(...(args as never[]));
  }
}
