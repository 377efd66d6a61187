// Tests of the explorer's page in a browser of this machine, from file://.
//
// usage: node page.mjs chromium|firefox PAGE.html FOLDER_OF_NODE_MODULES
import {existsSync, readFileSync, statSync} from 'node:fs';
import {createRequire} from 'node:module';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [browser_name, file, folder] = process.argv.slice(2),
  address = pathToFileURL(file).href,
  axe_source = readFileSync(createRequire(resolve(folder) + '/').resolve('axe-core/axe.min.js'), 'utf8');
const views = ['forces', 'wanted', 'why', 'direct', 'laws', 'watch', 'mine'],
  max_controls = 25;
let failures = 0,
  passes = 0;

function expect(is_met, what, found = '') {
  is_met ? ++passes : ++failures;
  if (!is_met) console.log('    failed: ' + what + (found === '' ? '' : '; found ' + JSON.stringify(found)));
}

// playwright-core 1.58.0 drives Debian's Firefox by WebDriver BiDi.
const playwright = createRequire(resolve(folder) + '/')('playwright-core'),
  program_of = names => names.map(name => '/usr/bin/' + name).find(path => existsSync(path));
const browser =
  browser_name === 'chromium'
    ? await playwright.chromium.launch({executablePath: program_of(['chromium', 'google-chrome']), args: ['--no-sandbox']})
    : await playwright.firefox.launch({channel: 'moz-firefox', executablePath: program_of(['firefox-esr', 'firefox']), timeout: 60000});

// Opens a page; messages has all that the console got, and what was requested from a network.
async function open(link, {width = 1280, height = 900, touch = false, prepare, reducedMotion} = {}) {
  const context = await browser.newContext({
    viewport: {width, height}, hasTouch: touch, ...(browser_name === 'chromium' ? {reducedMotion} : {}),
  });
  const page = await context.newPage(),
    messages = [];
  page.on('console', message => messages.push(message.type() + ': ' + message.text()));
  page.on('pageerror', error => messages.push('error: ' + error.message));
  page.on('request', request => {
    if (/^(https?|ws):/.test(request.url())) messages.push('request: ' + request.url());
  });
  if (prepare) await page.addInitScript(prepare);
  await page.goto(address + link);
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true', null, {timeout: 60000});
  return {page, messages, close: () => context.close()};
}

// A test of the page at a link; no test leaves a message in the console.
async function test(name, hash, options, run) {
  const before = failures,
    began = performance.now(),
    opened = await open(hash, options);
  try {
    await run(opened.page);
  } catch (error) {
    expect(false, error.stack.split('\n').slice(0, 4).join(' '));
  }
  expect(opened.messages.length === 0, name + ' leaves no message in the console', opened.messages);
  await opened.close();
  console.log(`  ${failures === before ? 'ok    ' : 'FAILED'} ${((performance.now() - began) / 1000).toFixed(1)} s  ${name}`);
}

const number = (page, id) =>
  page.evaluate(name => Number(document.querySelector(`.number[data-id="${name}"]`).dataset.value), id);
const settle = page => page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
const text_of = (page, id) => page.evaluate(name => document.getElementById(name).textContent, id);
const soon = {timeout: 60000};
const run_until = (page, seconds) =>
  page.waitForFunction(t => Number(document.querySelector('[data-id="t"]')?.dataset.value) > t, seconds, soon);
async function go_to(page, hash) {
  await page.evaluate(link => void (location.hash = link), hash);
  await settle(page);
}
const view_of = page => page.evaluate(() => document.body.dataset.question);
const centre = async (page, id) => {
  const box = await page.locator('#grip_' + id).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};
async function drag(page, id, by) {
  const from = await centre(page, id);
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let k = 1; k <= 5; ++k) await page.mouse.move(from[0] + (by[0] * k) / 5, from[1] + (by[1] * k) / 5);
  await page.mouse.up();
  await settle(page);
}

// A drag of one finger, as its events.
const drag_by_finger = ([id, dx, dy]) => {
  const grip = document.getElementById('grip_' + id),
    box = grip.getBoundingClientRect();
  grip.setPointerCapture = () => {}; // there is no finger that could be captured
  for (const [type, share] of [['down', 0], ...[1, 2, 3, 4, 5].map(k => ['move', k / 5]), ['up', 1]])
    grip.dispatchEvent(
      new PointerEvent('pointer' + type, {
        pointerId: 9, pointerType: 'touch', isPrimary: true, bubbles: true, cancelable: true,
        clientX: box.x + box.width / 2 + dx * share, clientY: box.y + box.height / 2 + dy * share,
      }),
    );
};

// Keeps what the page saves, as Firefox reports no download to playwright-core.
function keep_saved() {
  const create = URL.createObjectURL;
  URL.createObjectURL = blob => create((window.saved = blob));
}
async function saved_by(page, button) {
  await page.evaluate(() => (window.saved = null));
  await page.click(button);
  await page.waitForFunction(() => window.saved, null, soon);
  return page.evaluate(() => window.saved.text());
}
const open_more = page => page.evaluate(() => document.getElementById('more').setAttribute('open', ''));
// The controls that a visitor sees, and those that a finger misses.
const controls = () => {
  const shown = [...document.querySelectorAll('a, button, input, select, summary')].filter(
    control => control.checkVisibility() && !control.matches('.skip'),
  );
  const low = shown.filter(control => control.getBoundingClientRect().height < 43.5);
  return [shown.length, low.map(control => control.id || control.textContent)];
};

console.log(browser_name + ' ' + browser.version());
expect(statSync(file).size < 1.5e6, 'the page is one file of less than 1.5 MB', statSync(file).size);

await test('a student drags what the steps are about', '', {}, async page => {
  expect((await view_of(page)) === 'forces', 'the page begins with step 1');
  expect(/passive FME 2/.test(await text_of(page, 'answer')), 'the number of the area', await text_of(page, 'answer'));
  await drag(page, 'v', [-120, -10]);
  expect(/passive FME 3/.test(await text_of(page, 'answer')), 'v turned back flips the area', await text_of(page, 'answer'));
  await page.waitForFunction(() => location.hash.startsWith('#v1/?page=forces&'));
  await page.waitForTimeout(1000); // the link follows 0.3 s after what is shown
  const again = await open(await page.evaluate(() => location.hash));
  expect((await number(again.page, 'v')) === (await number(page, 'v')), 'the link brings the state back');
  await again.close();

  await go_to(page, '#v1/wanted');
  expect(/2\.54 N, 19\.3° off \(γ\)/.test(await text_of(page, 'answer')), 'the nearest force', await text_of(page, 'answer'));
  await drag(page, 'Fd', [-35, 0]);
  expect(/display it exactly/.test(await text_of(page, 'answer')), 'a force in the area', await text_of(page, 'answer'));

  await go_to(page, '#v1/direct');
  await page.locator('#alpha').fill('0.2');
  await settle(page);
  expect(/into the wall/.test(await text_of(page, 'answer')), 'a small alpha', await text_of(page, 'answer'));
  await page.click('#alpha_law');
  await settle(page);
  expect(Math.abs((await number(page, 'alpha')) - 0.5) < 1e-12, 'alpha of equation (12)');

  await go_to(page, '#v1/mine');
  await page.waitForFunction(() => /Not everywhere/.test(document.getElementById('answer').textContent));
  await drag(page, 'normal', [60, -20]);
  await page.waitForFunction(() => /scene=plane:0.12,0.2251,0.6\d+,-0.7\d+&.*&map.normal=0.6\d+,-0.7/.test(location.hash));
  await page.selectOption('#mechanism', 'five_bar_4');
  await page.waitForFunction(() => / 2 % of its reach/.test(answer.textContent));
});

await test('the curve leads out, the hand bounces without a law and glides under the recommended one', '#v1/why', {}, async page => {
  await page.waitForFunction(() => /Bounce: .* brake 2 holds/.test(answer.textContent), null, soon);
  await go_to(page, '#v1/watch');
  await page.waitForFunction(
    () => /bounced off the wall \d+ times under no control and never under velocity/.test(answer.textContent), null, soon,
  );
});

await test('each step has few controls, large enough for a finger', '', {touch: true, width: 390, height: 844}, async page => {
  for (const view of views) {
    await go_to(page, '#v1/' + view);
    const [count, low] = await page.evaluate(controls);
    expect(count <= max_controls && low.length === 0, view + ': controls', [count, low]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), view + ' is no wider than the phone');
  }
  await go_to(page, '#v1/fig2');
  const before = await number(page, 'x');
  await page.evaluate(drag_by_finger, ['handle', -30, 20]);
  await settle(page);
  expect((await number(page, 'x')) < before, 'the handle follows the finger');
});

await test('the keyboard reaches the grips, moves them, and chooses a step', '#v1/fig3-Fd2', {}, async page => {
  const names = [];
  for (let k = 0; k < 40 && names.length < 3; ++k) {
    await page.keyboard.press('Tab');
    const id = (await page.evaluate(() => document.activeElement.id)).replace('grip_', ''),
      value = {handle: 'x', v: 'v', Fd: 'Fd'}[id];
    if (!value) continue;
    names.push(id);
    const before = await number(page, value);
    await page.keyboard.press('ArrowLeft');
    await settle(page);
    expect((await number(page, value)) < before, id + ' goes to the left');
  }
  expect(names.length === 3, 'grips that Tab reaches', names);
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('3');
  await page.waitForFunction(() => document.body.dataset.question === 'why');
  await page.keyboard.press('Space');
  expect((await text_of(page, 'pause')) === 'Play', 'space pauses');
});

await test('the visitor takes the handle; a record replays, and opens as a log', '#v1/laws', {prepare: keep_saved}, async page => {
  await run_until(page, 0.2);
  await open_more(page);
  await page.click('#record');
  await page.locator('#stage').scrollIntoViewIfNeeded();
  await drag(page, 'handle', [-40, 30]);
  expect((await page.locator('#self').getAttribute('aria-pressed')) === 'false', 'the hand by itself has let go');
  await run_until(page, 0.3);
  await page.click('#record');
  const log = await saved_by(page, '#download');
  await page.setInputFiles('#open_file', {name: 'log.csv', mimeType: 'text/csv', buffer: Buffer.from(log)});
  await page.waitForFunction(() => / lines; (\d{3,}) of \1 capacities/.test(note.textContent), null, soon);
  await page.setInputFiles('#open_file', resolve('examples/catalogue/devices/five_bar.toml'));
  await page.waitForFunction(() => /five_bar.toml is open. Not shown: .*magnetorheological/.test(note.textContent));
});

await test('a link that cannot be opened leaves the page, which states the reason', '#v1/fig2', {prepare: keep_saved}, async page => {
  const device = '#v1/?page=wanted&mechanism=two_link';
  for (const [link, expected] of [
    ['#v1/fig99', /page = 'fig99': expected forces/],
    ['#v2/fig2', /link = '#v2\/fig2': expected #v1\//],
    ['#v1/?page=foo&mechanism=two_link', /page = 'foo': expected forces/],
    ['#v1/?mechanism=five_bar_4&q=3.1,0', /q = '3.1,0': expected joint positions at which the chain closes/],
    [device + '&foo', /setting = 'foo': expected NAME=VALUE/],
    [device + '&law=foo', /law = 'foo': expected one of/],
  ]) {
    await go_to(page, link);
    expect(expected.test(await text_of(page, 'warning')), link + ' has its reason', await text_of(page, 'warning'));
    expect((await view_of(page)) === 'forces', link + ' opens nothing');
  }
  await open_more(page);
  await page.fill('[name="mechanism.length_1"]', '-1');
  await page.press('[name="mechanism.length_1"]', 'Enter');
  await page.waitForFunction(() => /expected a finite number > 0/.test(refused.textContent));
  const svg = await saved_by(page, '#save_svg');
  expect(/^<svg.*<path/s.test(svg) && !/NaN|undefined/.test(svg), 'an SVG document', svg.slice(0, 80));
});

await test('each id opens, and each mechanism in each step', '', {}, async page => {
  const ids = await page.locator('#presets a').evaluateAll(links => links.map(link => link.dataset.id));
  expect(ids.length >= 26, 'presets', ids.length);
  for (const id of ids) {
    await go_to(page, '#v1/' + id);
    expect(await page.locator(`#presets [data-id="${id}"][aria-current="page"]`).count(), id + ' is current');
  }
  const mechanisms = await page.locator('#mechanism option').evaluateAll(all => all.map(option => option.value));
  await open_more(page);
  for (const mechanism of mechanisms) {
    await go_to(page, '#v1/forces');
    await page.selectOption('#mechanism', mechanism);
    for (const view of views) {
      await go_to(page, '#v1/' + view);
      expect((await page.inputValue('#mechanism')) === mechanism && (await view_of(page)) === view, `${mechanism} in ${view}`);
      expect((await text_of(page, 'refused')) + (await text_of(page, 'warning')) === '', `${mechanism} in ${view} is not refused`);
    }
  }
});

if (browser_name === 'chromium') {
  for (const width of [1280, 390])
    await test(`axe finds nothing and nothing jumps, ${width} pixels wide`, '', {width, height: 844, prepare: () => {
      window.shifts = [];
      new PerformanceObserver(list => window.shifts.push(...list.getEntries().map(entry => entry.value))).observe({type: 'layout-shift', buffered: true});
    }}, async page => {
      await page.waitForTimeout(300);
      expect((await page.evaluate(() => window.shifts)).length === 0, 'layout shifts');
      await page.evaluate(axe_source);
      for (const view of views)
        for (const name of ['light', 'dark']) {
          await go_to(page, '#v1/' + view);
          await page.evaluate(theme => {
            document.documentElement.dataset.theme = theme;
            document.getElementById('more').open = theme === 'dark';
          }, name);
          await page.waitForTimeout(200);
          const {violations} = await page.evaluate(async () => {
            const fades = document.getAnimations().filter(animation => animation instanceof CSSTransition);
            await Promise.allSettled(fades.map(fade => fade.finished));
            return window.axe.run(document, {resultTypes: ['violations']});
          });
          expect(violations.length === 0, `${view}, ${name}`, violations.map(v => v.id + ': ' + v.nodes[0].html.slice(0, 120)));
        }
    });

  await test('without motion the page shows a whole pass', '#v1/watch', {reducedMotion: 'reduce'}, async page => {
    await run_until(page, 2);
    expect((await text_of(page, 'pause')) === 'Play' && /\d+ times/.test(await text_of(page, 'answer')), 'a pass that is over');
  });
}

await browser.close();
console.log(`${browser_name}: ${passes} checks passed, ${failures} failed`);
process.exit(failures ? 1 : 0);
