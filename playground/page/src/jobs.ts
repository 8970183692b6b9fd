// The queue before the worker: one job at a time; of jobs with the same key only the newest counts.

import workerCode from "worker:code";
import type { Reply, Request } from "./worker";

interface Job {
  key: string;
  request: Request;
  resolve: (result: unknown) => void;
  reject: (error: Error) => void;
}

/** Thrown where a newer job took the place of this one. */
export class Superseded extends Error {}

const LONGEST = 20_000;

export class Jobs {
  private queue: Job[] = [];
  private running: Job | undefined;
  private worker: Worker | undefined;
  private timer = 0;

  /** The worker starts with its first job: the picture comes first. */
  constructor(private readonly bytes: Uint8Array) {}

  /** The result of a request. Pictures of the gallery wait for everything else. */
  run<T>(request: Request, key: string = request.kind): Promise<T> {
    return new Promise<T>((resolve, reject) => {
      this.queue = this.queue.filter((job) => {
        if (job.key === key) job.reject(new Superseded("a newer job took its place"));
        return job.key !== key;
      });
      this.queue.push({ key, request, resolve: resolve as (result: unknown) => void, reject });
      this.next();
    });
  }

  private start(): Worker {
    const url = URL.createObjectURL(new Blob([workerCode], { type: "text/javascript" }));
    const worker = new Worker(url);
    URL.revokeObjectURL(url);
    worker.postMessage(this.bytes);
    worker.onmessage = (event: MessageEvent<Reply>) => {
      const job = this.running;
      this.done();
      if (event.data.error !== undefined) job?.reject(new Error(event.data.error));
      else job?.resolve(event.data.result);
      this.next();
    };
    worker.onerror = (event) => {
      event.preventDefault();
      this.replace("the generator failed on this text, which is a defect of denhart");
    };
    return worker;
  }

  private done(): void {
    clearTimeout(this.timer);
    this.running = undefined;
  }

  private replace(why: string): void {
    this.worker?.terminate();
    this.worker = undefined;
    const job = this.running;
    this.done();
    job?.reject(new Error(why));
    this.next();
  }

  private next(): void {
    if (this.running) return;
    const urgent = this.queue.findIndex((job) => job.request.kind !== "thumbnail");
    const [job] = this.queue.splice(Math.max(urgent, 0), 1);
    if (!job) return;
    this.running = job;
    this.timer = window.setTimeout(() => this.replace("the generator takes too long for this text"), LONGEST);
    this.worker ??= this.start();
    this.worker.postMessage(job.request);
  }
}
