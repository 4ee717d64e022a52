declare module "leadscrew:lesson.wasm?url" {
  const address: string;
  export default address;
}
declare module "leadscrew:lesson.wasm?base64" {
  const base64: string;
  export default base64;
}
declare module "leadscrew:engine" {
  export { openEngine } from "./served";
}
declare module "*.css" {}
