declare module "leadscrew:lesson.wasm?url" {
  const address: string;
  export default address;
}
declare module "leadscrew:lesson.wasm?packed" {
  const base64: string;
  export default base64;
}
declare module "leadscrew:program.wasm?url" {
  const address: string;
  export default address;
}
declare module "leadscrew:program.wasm?packed" {
  const base64: string;
  export default base64;
}
declare module "leadscrew:engine" {
  export { openEngine } from "./served";
}
declare module "leadscrew:planner" {
  export { compiledModule, startWorker } from "./planner_served";
}
declare module "leadscrew:scene" {
  export { startWorker } from "../program/scene_served";
}
declare module "*?worker&inline" {
  const make: new () => Worker;
  export default make;
}
declare module "*?raw" {
  const text: string;
  export default text;
}
declare module "*.css" {}
