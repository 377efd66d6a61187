// The script time of a frame with three laws side by side, beside that of an empty page: a report, as no
// test asserts a time.
//
// usage: node frames.mjs PAGE.html FOLDER_OF_NODE_MODULES
import {writeFileSync, mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {open_browser, program_of} from './browsers.mjs';

const [file, folder] = process.argv.slice(2),
  measured = 4000; // [ms]
const scratch = mkdtempSync(join(tmpdir(), 'explorer-')),
  empty = join(scratch, 'empty.html');
writeFileSync(
  empty,
  '<!doctype html><html lang="en" data-ready="true"><title>empty</title><script>requestAnimationFrame(function next() { requestAnimationFrame(next); })</script>',
);

// Times the callbacks of frames and of messages, before any script of the page runs.
function watch_frames() {
  window.frame_times = [];
  window.frame_scripts = [];
  let script = 0;
  const timed = call =>
    function (...values) {
      const began = performance.now();
      try {
        return call.apply(this, values);
      } finally {
        script += performance.now() - began;
      }
    };
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = call => request(timed(call));
  const setter = Object.getOwnPropertyDescriptor(Worker.prototype, 'onmessage');
  Object.defineProperty(Worker.prototype, 'onmessage', {
    ...setter,
    set(call) {
      setter.set.call(this, timed(call));
    },
  });
  let last = 0;
  request(function next(now) {
    if (last) {
      window.frame_times.push(now - last);
      window.frame_scripts.push(script);
    }
    script = 0;
    last = now;
    request(next);
  });
}

const at = (numbers, share) => [...numbers].sort((a, b) => a - b)[Math.floor(share * (numbers.length - 1))];

for (const name of ['chromium', 'firefox']) {
  if (!program_of(name)) continue;
  const browser = await open_browser(folder, name);
  for (const [what, address] of [
    ['empty page', pathToFileURL(empty).href],
    ['three laws', pathToFileURL(file).href + '#v1/laws'],
  ]) {
    const opened = await browser.open(address, {prepare: watch_frames});
    await opened.page.waitForTimeout(2000);
    await opened.page.evaluate(() => {
      window.frame_times.length = window.frame_scripts.length = 0;
    });
    const before = await opened.page.evaluate(() =>
      Number(document.querySelector('.number[data-id="t"]')?.dataset.value),
    );
    await opened.page.waitForTimeout(measured);
    const {times, scripts, after} = await opened.page.evaluate(() => ({
      times: window.frame_times,
      scripts: window.frame_scripts,
      after: Number(document.querySelector('.number[data-id="t"]')?.dataset.value),
    }));
    console.log(
      `${name} ${what}: ${times.length} frames, interval median ${at(times, 0.5).toFixed(1)} ms, 95 % ${at(times, 0.95).toFixed(1)} ms; script a frame median ${at(scripts, 0.5).toFixed(2)} ms, 95 % ${at(scripts, 0.95).toFixed(2)} ms` +
        (after > before
          ? `; ${(after - before).toFixed(2)} s simulated in ${(measured / 1000).toFixed(2)} s`
          : ''),
    );
    await opened.close();
  }
  await browser.close();
}
rmSync(scratch, {recursive: true});
