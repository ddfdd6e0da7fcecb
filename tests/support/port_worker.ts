import { expose } from 'comlink';

/** Stands in for a Worker in Node: the service answers on the other side of a channel. */
export class PortWorker extends EventTarget {
  ended = false;
  protected readonly inside: MessagePort;
  private readonly port: MessagePort;

  constructor(service?: object) {
    super();
    const { port1, port2 } = new MessageChannel();
    this.port = port1;
    this.inside = port2;
    if (service) this.serve(service);
  }

  protected serve(service: object): void {
    expose(service, this.inside);
  }

  postMessage(message: unknown, transfer: Transferable[]): void {
    this.port.postMessage(message, transfer);
  }

  override addEventListener(type: string, listener: EventListener): void {
    if (type === 'message') this.port.addEventListener(type, listener);
    else super.addEventListener(type, listener);
  }

  start(): void {
    this.port.start();
  }

  terminate(): void {
    this.ended = true;
    this.port.close();
  }

  /** As when the module inside traps. */
  break(message: string): void {
    this.dispatchEvent(Object.assign(new Event('error'), { message }));
  }

  asWorker(): Worker {
    return this as unknown as Worker;
  }
}
