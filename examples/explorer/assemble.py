#!/usr/bin/env python3
"""One HTML file of the explorer: page/index.html with everything in it.

usage: assemble.py ENGINE_FOLDER OUTPUT.html

ENGINE_FOLDER has engine.js and engine.wasm. In page/index.html these comments are replaced:

    <!-- explorer:style -->     the style sheets page/*.css, in the order of their names
    <!-- explorer:engine -->    <script id="engine-code" type="text/plain">, the glue code of emscripten, which defines
                                explorer_engine(options); and <script id="engine-wasm" type="text/plain">, the engine
                                compressed by gzip, in base64: the page passes its bytes, after
                                new DecompressionStream('gzip'), as options.wasmBinary
    <!-- explorer:worker -->    <script id="worker-code" type="text/plain">, page/worker.js with what it imports
    <!-- explorer:main -->      <script type="module">, page/main.js with what it imports
    <!-- explorer:licences -->  the licences of what is included, as text

Modules are joined without a bundler, so they keep to three rules: imports are lines of the form
"import { a, b } from './x.js';", exports stand before a declaration ("export function a"), and no two modules declare
one name at their top level.
"""
import base64
import gzip
import html
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE / 'page'
IMPORT = re.compile(r"^import \{[^}]*\} from '\./([\w./-]+)';[ \t]*\n", re.MULTILINE)
EXPORT = re.compile(r'^export (?=(async )?function|const|let|class)', re.MULTILINE)
DECLARED = re.compile(r'^(?:async )?(?:function\*?|const|let|class) ([\w$]+)', re.MULTILINE)


def joined(entry):
    """The text of a module after those that it imports, each once."""
    parts, done, owner = [], set(), {}

    def add(name, stack):
        if name in stack:
            sys.exit(f'error: {name} imports itself by {" > ".join(stack)}; take what both need into a third module')
        if name in done:
            return
        text = (PAGE / name).read_text()
        for needed in IMPORT.findall(text):
            add(needed, [*stack, name])
        done.add(name)
        text = EXPORT.sub('', IMPORT.sub('', text))
        left = re.search(r'^(import|export)\b.*$', text, re.MULTILINE)
        if left:
            sys.exit(f'error: {name}: "{left[0]}": expected an import or export as assemble.py --help describes')
        for declared in DECLARED.findall(text):
            if declared in owner:
                sys.exit(f'error: {name} and {owner[declared]} both declare {declared}; rename one')
            owner[declared] = name
        parts.append(f'// {name}\n{text}')

    add(entry, [])
    return '\n'.join(parts)


def script(attributes, text):
    """A script element; the text may not end it."""
    return f'<script {attributes}>\n{re.sub("</(?=script)", "<" + chr(92) + "/", text)}\n</script>'


def licences():
    """The licences of the library and of what is compiled in."""
    texts = []
    for path in [HERE.parents[1] / 'LICENSE', *sorted((HERE / 'licences').glob('*.txt'))]:
        texts.append(path.read_text().strip())
    return html.escape('\n\n'.join(texts))


def main():
    """Writes the page."""
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    engine, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    page = (PAGE / 'index.html').read_text()
    wasm = base64.b64encode(gzip.compress((engine / 'engine.wasm').read_bytes(), 9, mtime=0)).decode()
    made = {
        'style': lambda: '<style>\n' + '\n'.join(p.read_text() for p in sorted(PAGE.glob('*.css'))) + '</style>',
        'engine': lambda: script('id="engine-code" type="text/plain"', (engine / 'engine.js').read_text()) +
                          script('id="engine-wasm" type="text/plain"', wasm),
        'worker': lambda: script('id="worker-code" type="text/plain"', joined('worker.js')),
        'main': lambda: script('type="module"', joined('main.js')),
        'licences': licences,
    }
    for name, make in made.items():
        mark = f'<!-- explorer:{name} -->'
        if mark in page:
            page = page.replace(mark, make())
    output.write_text(page)
    print(f'{output}: {len(page.encode()) / 1e6:.2f} MB')


main()
