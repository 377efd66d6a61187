// The engine in WebAssembly as the page wraps it, for Node.
import {readFileSync} from 'node:fs';
import {load_engine} from '../../examples/explorer/page/engine.js';

export const load = folder => load_engine(readFileSync(folder + '/engine.js', 'utf8'), readFileSync(folder + '/engine.wasm'));
