// The engine: the library's headers, compiled to WebAssembly, as objects of the page. Every law, every
// kinematics and every constant is in there. bindings.cpp lists its functions; each object that it makes ends by delete().

// code: the text that defines explorer_engine; bytes: the WebAssembly.
export async function load_engine(code, bytes) {
  const make = new Function(code + '\n;return explorer_engine;')();
  const silent = () => {};
  const engine = await make({wasmBinary: bytes, print: silent, printErr: silent, noExitRuntime: true});
  const {prototype} = engine.device;
  for (const name of ['outline', 'locus', 'walls']) {
    const numbers_of = prototype[name];
    prototype[name] = function (...given) {
      const numbers = numbers_of.apply(this, given);
      return Array.from({length: numbers.length / 3}, (_, k) => [...numbers.subarray(3 * k, 3 * k + 3)]);
    };
  }
  // The name of a value that is one of an enumeration.
  prototype.word = function (id, k = 0) {
    return this.layout.find(entry => entry.id === id)?.words[this.value(id)[k]] || '';
  };
  const with_layout = made => made && Object.assign(made, {layout: made.columns()});
  return {
    catalogue: engine.catalogue(),
    error: () => engine.error(),
    device: settings => with_layout(engine.new_device(settings)),
    simulation: settings => with_layout(engine.new_simulation(settings)),
    open_log: (settings, log) => with_layout(engine.open_log(settings, log)),
  };
}

// The bytes of a text in base64, unpacked where gzip packed them.
export async function bytes_of(text) {
  const raw = atob(text.replace(/\s+/g, '')),
    bytes = Uint8Array.from(raw, letter => letter.charCodeAt(0));
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(unpacked).arrayBuffer());
}
