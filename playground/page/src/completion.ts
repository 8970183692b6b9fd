// Completion of keys and words in the arm file, from the JSON schema.

import type { Completion, CompletionContext, CompletionResult } from "@codemirror/autocomplete";
import type { Text } from "@codemirror/state";

interface Schema {
  $ref?: string;
  type?: string;
  properties?: Record<string, Schema>;
  additionalProperties?: Schema | boolean;
  items?: Schema;
  enum?: unknown[];
  anyOf?: Schema[];
  description?: string;
  definitions?: Record<string, Schema>;
}

/** The keys that lead to a place of a text, outermost first; `[]` is a list. */
export function pathAt(lines: string[], line: number, column: number): string[] {
  const path: string[] = [];
  const before = (lines[line] ?? "").slice(0, column);
  const indentation = (text: string): number => text.length - text.replace(/^[ -]*/, "").length;
  let indent = indentation(before);
  // Braces of this line that are still open, with the keys before them.
  const inner: string[] = [];
  const open: string[][] = [];
  for (const part of before.matchAll(/(\w+)\s*:\s*\{|\{|\}|(\w+)\s*:\s*\[|\[|\]/g)) {
    if (part[0].endsWith("{") || part[0].endsWith("[")) open.push([part[1] ?? part[2] ?? "", part[0].endsWith("[") ? "[]" : ""]);
    else open.pop();
  }
  for (const [key, list] of open) inner.push(...[key, list].filter((word): word is string => !!word));
  if (/^\s*-/.test(before)) {
    path.unshift("[]");
    indent = before.indexOf("-") + 1;
  } else if (indent > 0) {
    // Within the item of a list that began above.
    for (let above = line - 1; above >= 0; above--) {
      const text = lines[above] ?? "";
      if (!text.trim() || indentation(text) > indent) continue;
      if (/^\s*-/.test(text) && indentation(text) === indent) {
        path.unshift("[]");
        indent = text.indexOf("-") + 1;
      }
      if (indentation(text) < indent || path.length) break;
    }
  }
  for (let above = line - 1; above >= 0 && indent > 0; above--) {
    const text = lines[above] ?? "";
    const key = /^(\s*)(\w+)\s*:\s*(#.*)?$/.exec(text);
    if (key && key[1]!.length < indent) {
      path.unshift(key[2]!);
      indent = key[1]!.length;
    }
  }
  return [...path, ...inner];
}

function resolve(schema: Schema | undefined, root: Schema): Schema[] {
  if (!schema) return [];
  if (schema.$ref) return resolve(root.definitions?.[schema.$ref.split("/").pop() ?? ""], root);
  return schema.anyOf ? schema.anyOf.flatMap((one) => resolve(one, root)) : [schema];
}

function inside(schemas: Schema[], path: string[], root: Schema): Schema[] {
  return path.reduce(
    (at, key) =>
      at.flatMap((schema) => {
        if (key === "[]") return resolve(schema.items, root);
        const other = typeof schema.additionalProperties === "object" ? schema.additionalProperties : undefined;
        return resolve(schema.properties?.[key] ?? other, root);
      }),
    schemas,
  );
}

const describe = (of: Schema, root: Schema): string => of.description ?? resolve(of, root)[0]?.description ?? "";

/** The description of the key at a place of the text, and where the key stands. */
export function describeFrom(root: Schema): (document: Text, position: number) => { from: number; to: number; words: string } | undefined {
  return (document, position) => {
    const line = document.lineAt(position);
    for (const found of line.text.matchAll(/([A-Za-z_]\w*)(?=\s*:)/g)) {
      const [from, to] = [line.from + found.index, line.from + found.index + found[0].length];
      if (position < from || position > to || line.text.slice(0, found.index).includes("#")) continue;
      const path = pathAt(document.toString().split("\n"), line.number - 1, found.index);
      const of = inside([root], path, root).map((schema) => schema.properties?.[found[0]]).find(Boolean);
      const words = of && describe(of, root);
      return words ? { from, to, words } : undefined;
    }
    return undefined;
  };
}

/** Completes what is typed before the cursor. */
export function completeFrom(root: Schema): (context: CompletionContext) => CompletionResult | null {
  return (context) => {
    const document = context.state.doc;
    const here = document.lineAt(context.pos);
    const before = here.text.slice(0, context.pos - here.from);
    if (/#/.test(before)) return null;
    const word = /[\w-]*$/.exec(before)![0].replace(/^-+/, "");
    const start = context.pos - word.length;
    const path = pathAt(document.toString().split("\n"), here.number - 1, before.length - word.length);
    // Behind a key stands its value.
    const value = /(\w+)\s*:\s*$/.exec(before.slice(0, before.length - word.length));
    const schemas = inside([root], value ? [...path, value[1]!] : path, root);
    let options: Completion[];
    if (value) {
      if (!word && !context.explicit) return null;
      options = schemas.flatMap((schema) => (schema.enum ?? (schema.type === "boolean" ? [true, false] : [])).map((one) => ({ label: String(one), type: "enum" })));
    } else {
      if (!word && !context.explicit) return null;
      options = schemas.flatMap((schema) =>
        Object.entries(schema.properties ?? {}).map(([key, of]) => ({ label: key, type: "property", apply: `${key}: `, info: describe(of, root) })));
    }
    const seen = new Set<string>();
    options = options.filter((option) => !seen.has(option.label) && seen.add(option.label));
    return options.length ? { from: start, options, validFor: /^\w*$/ } : null;
  };
}
