// Colors of words in the editor and in generated code; they are those of the style sheet.

import { HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import { tags } from "@lezer/highlight";

export const highlighting = syntaxHighlighting(
  HighlightStyle.define([
    { tag: [tags.comment, tags.lineComment, tags.blockComment, tags.docComment], color: "var(--code-comment)", fontStyle: "italic" },
    { tag: [tags.number, tags.bool, tags.literal], color: "var(--code-number)" },
    { tag: [tags.string, tags.special(tags.string)], color: "var(--code-string)" },
    { tag: [tags.keyword, tags.modifier, tags.controlKeyword, tags.definitionKeyword, tags.self], color: "var(--code-keyword)" },
    { tag: [tags.definition(tags.propertyName), tags.propertyName, tags.attributeName], color: "var(--code-key)" },
    { tag: [tags.typeName, tags.className, tags.namespace], color: "var(--code-type)" },
    { tag: [tags.function(tags.variableName), tags.macroName], color: "var(--code-function)" },
    { tag: tags.meta, color: "var(--code-comment)" },
  ]),
);
