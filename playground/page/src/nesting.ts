// How deep a text nests lists and maps. Trees of a text are walked by recursion, which ends where the stack does.

/** An arm file nests four deep. */
export const DEEPEST = 64;

/** True where brackets, or dashes of lists on one line, nest deeper than an arm file may. Strings and comments do not count. */
export function isTooDeep(text: string): boolean {
  if (/^[ \t]*(?:[-?][ \t]+){64}/m.test(text)) return true;
  let depth = 0;
  let quote = "";
  for (let at = 0; at < text.length; at++) {
    const letter = text[at]!;
    if (quote) {
      if (letter === "\\" && quote === '"') at++;
      else if (letter === quote) quote = "";
      continue;
    }
    // A quote within a word is an apostrophe, and a number sign within a word is a letter.
    const isStart = at === 0 || " \t\n\r[{,:".includes(text[at - 1]!);
    if (letter === "[" || letter === "{") depth++;
    else if (letter === "]" || letter === "}") depth = Math.max(depth - 1, 0);
    else if (isStart && (letter === '"' || letter === "'")) quote = letter;
    else if (isStart && letter === "#") at = (text.indexOf("\n", at) + 1 || text.length) - 1;
    if (depth > DEEPEST) return true;
  }
  return false;
}
