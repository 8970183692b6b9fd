// The worker's bundle as text, and style sheets: build.mjs.
declare module "worker:code" {
  const code: string;
  export default code;
}
