// States to go back to.

const MOST = 200;

export class History<T> {
  private states: string[] = [];
  private at = -1;

  /** Adds a state behind the present one, unless it is the same; what was undone is gone. */
  push(state: T): void {
    const text = JSON.stringify(state);
    if (text === this.states[this.at]) return;
    this.states = [...this.states.slice(0, this.at + 1), text].slice(-MOST);
    this.at = this.states.length - 1;
  }

  back(): T | undefined {
    return this.go(-1);
  }

  forward(): T | undefined {
    return this.go(1);
  }

  private go(step: number): T | undefined {
    const state = this.states[this.at + step];
    if (state === undefined) return undefined;
    this.at += step;
    return JSON.parse(state) as T;
  }
}
