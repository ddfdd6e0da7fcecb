declare module '#wasm/solver.js' {
  const createSolver: import('./module.ts').CreateSolver;
  export default createSolver;
}

declare module '#wasm/solver.wasm?url' {
  const url: string;
  export default url;
}
