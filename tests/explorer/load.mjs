// The engine in WebAssembly as the page wraps it, for Node.
import {createRequire} from 'node:module';
import {readFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {load_engine} from '../../examples/explorer/page/engine.js';

export function load(folder) {
  const path = name => resolve(folder, name);
  Object.assign(globalThis, {require: createRequire(import.meta.url), __dirname: folder, __filename: path('engine.js')});
  return load_engine(readFileSync(path('engine.js'), 'utf8'), readFileSync(path('engine.wasm')));
}
