// Colors of the picture: those of denhart-draw, which every eye tells apart (draw/src/theme.rs).

const dark = matchMedia("(prefers-color-scheme: dark)");

export const isDark = (): boolean => dark.matches;
export const onThemeChange = (listener: () => void): void => dark.addEventListener("change", listener);

const SOLUTIONS: [number, number][] = [
  [0x0072b2, 0x3d9fe8], [0xd55e00, 0xff7a24], [0x009e73, 0x1fc99a], [0xcc79a7, 0xe59ac6],
  [0x3a3f45, 0xe6e9ec], [0xe69f00, 0xb0702c], [0x56b4e9, 0xa5dcff], [0x8a5a2b, 0xf0e442],
];

const ROLES = {
  background: [0xffffff, 0x14181d],
  ink: [0x1f2328, 0xe6e9ec],
  grid: [0xd9dee3, 0x2a3139],
  link: [0x9aa7b4, 0x66727e],
  joint: [0x4c5866, 0xaab4be],
  x: [0xc4500a, 0xff8a3d],
  y: [0x00805c, 0x1fc99a],
  z: [0x0064a0, 0x52adf0],
  measure: [0x7a3e8f, 0xcf9ae0],
  deciding: [0xc4138f, 0xff7ad9],
  target: [0xb3123f, 0xff6b8f],
  limit: [0xd01c2e, 0xff4d5e],
  singular: [0xf08c00, 0xffa726],
  marked: [0xffc400, 0xffd54a],
} as const;

export function color(role: keyof typeof ROLES): number {
  return ROLES[role][isDark() ? 1 : 0];
}

export function solutionColor(index: number): number {
  return SOLUTIONS[index % SOLUTIONS.length]?.[isDark() ? 1 : 0] ?? 0;
}

export const css = (value: number): string => `#${value.toString(16).padStart(6, "0")}`;

/** Black or white, whichever is read better on a color: their contrast by relative luminance (WCAG 2.2) is at least 4.5. */
export function inkOn(hex: number): string {
  const [red = 0, green = 0, blue = 0] = [16, 8, 0].map((shift) => {
    const part = ((hex >> shift) & 255) / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  const luminance = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  return 1.05 / (luminance + 0.05) > (luminance + 0.05) / 0.05 ? "#ffffff" : "#000000";
}
