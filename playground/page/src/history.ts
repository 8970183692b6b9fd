// States to go back to.

const MOST = 200;
/** States of one series that follow each other so soon are one, ms. */
const SOON = 1500;

export class History<T> {
  private states: string[] = [];
  private at = -1;
  private series: string | undefined;
  private time = 0;

  /** Adds a state behind the present one, unless it is the same; what was undone is gone. */
  push(state: T, series?: string): void {
    const text = JSON.stringify(state);
    const now = performance.now();
    const isSame = series !== undefined && series === this.series && now - this.time < SOON;
    this.time = now;
    this.series = series;
    if (text === this.states[this.at]) return;
    this.states = [...this.states.slice(0, this.at + (isSame ? 0 : 1)), text].slice(-MOST);
    this.at = this.states.length - 1;
  }

  present(): T | undefined {
    return this.state(0);
  }

  /** True if there is a state so many steps away. */
  has(step: number): boolean {
    return this.states[this.at + step] !== undefined;
  }

  /** The state so many steps away, which becomes the present one. */
  go(step: number): T | undefined {
    const found = this.state(step);
    if (found === undefined) return undefined;
    this.at += step;
    this.series = undefined;
    return found;
  }

  private state(step: number): T | undefined {
    const text = this.states[this.at + step];
    return text === undefined ? undefined : (JSON.parse(text) as T);
  }
}
