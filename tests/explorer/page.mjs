// Tests of the explorer's page in a browser of this machine, from file://.
//
// usage: node page.mjs chromium|firefox PAGE.html FOLDER_OF_NODE_MODULES [VALUES]
//
// EXPLORER_TEST=WORDS runs the tests whose names have these words.
// VALUES: what the native engine prints of each preset, to compare with what the page shows.
import {readFileSync, statSync} from 'node:fs';
import {createRequire} from 'node:module';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {open_browser} from './browsers.mjs';
import {native_values, same_value} from './values.mjs';

const [browser_name, file, folder, values_file] = process.argv.slice(2),
  only = process.env.EXPLORER_TEST;
const path_of = name => createRequire(resolve(folder) + '/').resolve(name);
const address = pathToFileURL(file).href,
  axe_source = readFileSync(path_of('axe-core/axe.min.js'), 'utf8');
let failures = 0,
  passes = 0;

function expect(is_met, what, found = '') {
  if (is_met) {
    ++passes;
    return;
  }
  ++failures;
  console.log('    failed: ' + what + (found === '' ? '' : '; found ' + JSON.stringify(found)));
}

async function test(name, run) {
  if (only && !name.includes(only)) return;
  const before = failures;
  try {
    await run();
  } catch (error) {
    ++failures;
    console.log('    failed: ' + error.stack.split('\n').slice(0, 4).join(' '));
  }
  console.log((failures === before ? '  ok      ' : '  FAILED  ') + name);
}

const number = (page, id, index = 0) =>
  page
    .locator(`.number[data-id="${id}"][data-index="${index}"]`)
    .first()
    .getAttribute('data-value')
    .then(Number);
const settle = page =>
  page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
const centre = async (page, id) => {
  const box = await page.locator('#grip_' + id).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};

async function drag_by_mouse(page, from, by) {
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let k = 1; k <= 5; ++k) await page.mouse.move(from[0] + (by[0] * k) / 5, from[1] + (by[1] * k) / 5);
  await page.mouse.up();
  await settle(page);
}

// A drag of one finger. Chromium makes it of touches; playwright-core sends none to Firefox, which gets the
// events of a finger itself.
async function drag_by_touch(browser, page, id, by) {
  const [x, y] = await centre(page, id);
  if (browser.name === 'chromium') {
    const session = await page.context().newCDPSession(page),
      point = share => [{x: x + by[0] * share, y: y + by[1] * share, id: 1}];
    await session.send('Input.dispatchTouchEvent', {type: 'touchStart', touchPoints: point(0)});
    for (let k = 1; k <= 5; ++k)
      await session.send('Input.dispatchTouchEvent', {type: 'touchMove', touchPoints: point(k / 5)});
    await session.send('Input.dispatchTouchEvent', {type: 'touchEnd', touchPoints: []});
  } else
    await page.evaluate(
      ([id, x, y, dx, dy]) => {
        const grip = document.getElementById('grip_' + id);
        grip.setPointerCapture = () => {}; // there is no finger that could be captured
        const send = (type, share) =>
          grip.dispatchEvent(
            new PointerEvent(type, {
              pointerId: 9,
              pointerType: 'touch',
              isPrimary: true,
              bubbles: true,
              cancelable: true,
              clientX: x + dx * share,
              clientY: y + dy * share,
            }),
          );
        send('pointerdown', 0);
        for (let k = 1; k <= 5; ++k) send('pointermove', k / 5);
        send('pointerup', 1);
      },
      [id, x, y, ...by],
    );
  await settle(page);
}

// Keeps the texts of files that the page saves, as Firefox reports no download to playwright-core.
function keep_saved() {
  const create = URL.createObjectURL;
  URL.createObjectURL = blob => {
    window.saved = blob;
    return create(blob);
  };
}

// The text of the file that a click saves.
async function saved_by(page, button) {
  await page.evaluate(() => {
    window.saved = null;
  });
  await page.click(button);
  await page.waitForFunction(() => window.saved, null, {timeout: 20000});
  return page.evaluate(() => window.saved.text());
}

// Collects what moved by itself on the page.
function watch_shifts() {
  window.shifts = [];
  new PerformanceObserver(list => window.shifts.push(...list.getEntries().map(entry => entry.value))).observe(
    {
      type: 'layout-shift',
      buffered: true,
    },
  );
}

async function in_browser(browser) {
  console.log(browser.name + ' ' + browser.version);
  const with_page = async (hash, options, run) => {
    const opened = await browser.open(address + hash, options);
    try {
      await run(opened.page, opened);
    } finally {
      expect(opened.messages.length === 0, hash + ' leaves no message in the console', opened.messages);
      await opened.close();
    }
  };

  await test('the page opens, moves by itself, and loads nothing from a network', () =>
    with_page('', {}, async page => {
      await page.waitForFunction(
        () => Number(document.querySelector('.number[data-id="t"]')?.dataset.value) > 0.5,
        null,
        {timeout: 30000},
      );
      expect((await page.title()) !== '', 'the page has a title');
      expect(
        (await page.locator('#questions a[aria-current="page"]').count()) === 1,
        'one question is current',
      );
      const before = await number(page, 't');
      await page.waitForTimeout(700);
      expect((await number(page, 't')) > before, 'the simulated time goes on');
    }));

  await test('a hand along the wall leaves it again and again without a law, and never under velocity_direct_control', () =>
    with_page('#v1/watch', {}, async page => {
      const read = () =>
        [...document.querySelectorAll('#results tbody tr')].map(row => [
          row.querySelector('th').textContent,
          Number(row.querySelector('td').textContent),
        ]);
      await page.waitForFunction(`(${read})()[0]?.[1] >= 2`, null, {timeout: 60000});
      const rows = await page.evaluate(read);
      expect(rows.length === 2 && rows[0][1] >= 2 && rows[1][1] === 0, 'separations of the two laws', rows);
    }));

  await test('the mouse drags the handle, and the heads of v and of the wanted force', () =>
    with_page('#v1/fig3-Fd2', {}, async page => {
      await settle(page);
      for (const [grip, id, by] of [
        ['handle', 'x', [-30, 20]],
        ['v', 'v', [40, -20]],
        ['Fd', 'Fd', [-50, 30]],
      ]) {
        const before = [await number(page, id, 0), await number(page, id, 1)];
        await drag_by_mouse(page, await centre(page, grip), by);
        const after = [await number(page, id, 0), await number(page, id, 1)];
        expect(
          Math.sign(after[0] - before[0]) === Math.sign(by[0]) &&
            Math.sign(after[1] - before[1]) === -Math.sign(by[1]),
          grip + ' follows the mouse',
          [before, after],
        );
      }
      await page.waitForTimeout(500);
      expect((await page.evaluate(() => location.hash)).startsWith('#v1/?'), 'the link carries the state');
      const link = await page.evaluate(() => location.href),
        x = await number(page, 'x', 0);
      const again = await browser.open(link);
      await settle(again.page);
      expect((await number(again.page, 'x', 0)) === x, 'the link brings the state back');
      await again.close();
    }));

  await test('a finger drags the handle', () =>
    with_page('#v1/fig2', {touch: true, width: 390, height: 844}, async page => {
      await page.locator('#stage').scrollIntoViewIfNeeded();
      await settle(page);
      const before = await number(page, 'x', 0);
      await drag_by_touch(browser, page, 'handle', [-30, 20]);
      expect((await number(page, 'x', 0)) < before, 'the handle follows the finger', [
        before,
        await number(page, 'x', 0),
      ]);
      expect(
        await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth),
        'the page is no wider than the phone',
      );
    }));

  await test('the keyboard reaches the handle and the arrowheads, moves them, and chooses a question', () =>
    with_page('#v1/fig3-Fd2', {}, async page => {
      await settle(page);
      const names = [];
      for (let k = 0; k < 60 && names.length < 4; ++k) {
        await page.keyboard.press('Tab');
        const id = await page.evaluate(() => document.activeElement.id);
        if (!id.startsWith('grip_')) continue;
        names.push(id);
        if (id === 'grip_scene') continue;
        const value = {grip_handle: 'x', grip_v: 'v', grip_Fd: 'Fd'}[id],
          before = await number(page, value, 0);
        await page.keyboard.press('ArrowLeft');
        await settle(page);
        expect((await number(page, value, 0)) < before, id + ' goes to the left');
        expect(
          (await page.evaluate(() => document.activeElement.getAttribute('aria-label'))).length > 5,
          id + ' has a name',
        );
      }
      expect(names.length === 4, 'grips that Tab reaches', names);
      await page.keyboard.press('5');
      await page.waitForFunction(() => document.body.dataset.question === 'laws');
      await page.locator('#stage').click({position: {x: 5, y: 5}, trial: true});
      await page.evaluate(() => document.activeElement.blur());
      await page.keyboard.press('Space');
      expect((await page.locator('#pause').getAttribute('aria-pressed')) === 'true', 'space pauses');
    }));

  await test('the visitor takes the handle of a simulation; a record replays, and opens as a log', () =>
    with_page('#v1/laws', {prepare: keep_saved}, async page => {
      await page.waitForFunction(
        () => Number(document.querySelector('.number[data-id="t"]')?.dataset.value) > 0.2,
        null,
        {timeout: 30000},
      );
      await page.click('#record');
      await page.waitForTimeout(300);
      await page.locator('#stage').scrollIntoViewIfNeeded();
      const from = await centre(page, 'handle');
      await page.mouse.move(...from);
      await page.mouse.down();
      for (let k = 0; k < 12; ++k) {
        await page.mouse.move(from[0] - 4 * k, from[1] + 3 * k);
        await page.waitForTimeout(40);
      }
      expect(
        (await page.locator('#self').getAttribute('aria-pressed')) === 'false',
        'the hand by itself has let go',
      );
      await page.mouse.up();
      await page.click('#record');
      const log = await saved_by(page, '#download');
      expect(log.split('\n').length > 200, 'lines of the log', log.split('\n').length);
      await page.setInputFiles('#open_log', {
        name: 'log.csv',
        mimeType: 'text/csv',
        buffer: Buffer.from(log),
      });
      await page.waitForFunction(
        () =>
          /lines|refused|expected/.test(document.getElementById('note').textContent) &&
          !/replays with/.test(document.getElementById('note').textContent),
        null,
        {timeout: 20000},
      );
      const note = await page.locator('#note').textContent(),
        found = /(\d+) of (\d+) capacities/.exec(note);
      expect(
        found && Number(found[2]) > 100 && found[1] === found[2],
        'all capacities of the log are those of the law',
        note,
      );
      await page.click('#replay');
      await page.waitForTimeout(300);
      expect((await number(page, 't')) > 0, 'the replay runs');
    }));

  if (browser.name === 'chromium')
    await test('the page says so where the simulation falls behind real time', () =>
      with_page('#v1/laws', {}, async page => {
        await page.waitForFunction(
          () => Number(document.querySelector('.number[data-id="t"]')?.dataset.value) > 0.2,
          null,
          {timeout: 30000},
        );
        const stall = () => {
          for (const began = performance.now(); performance.now() - began < 500;);
        };
        await page.workers()[0].evaluate(stall);
        await page.waitForFunction(() => !document.getElementById('late').hidden, null, {timeout: 10000});
        expect(/real time/.test(await page.locator('#late').textContent()), 'the badge names real time');
        await page.waitForFunction(() => document.getElementById('late').hidden, null, {timeout: 30000});
      }));

  if (browser.name === 'chromium')
    for (const width of [1280, 390])
      await test(`nothing jumps while the page loads, ${width} pixels wide`, () =>
        with_page('', {width, prepare: watch_shifts}, async page => {
          await page.waitForTimeout(1500);
          const shifts = await page.evaluate(() => window.shifts);
          expect(shifts.length === 0, 'layout shifts', shifts);
        }));

  await test('a refused setting is explained in the words of the library, and nothing changes', () =>
    with_page('#v1/mine', {}, async page => {
      const field = page.locator('#form input').first(),
        old = await field.inputValue();
      await field.fill('-1');
      await field.press('Enter');
      await page.waitForFunction(() => !document.getElementById('refused').hidden);
      expect(
        /expected/.test(await page.locator('#refused').textContent()),
        'the reason says what was expected',
        await page.locator('#refused').textContent(),
      );
      await field.blur();
      await page.waitForTimeout(100);
      expect(
        (await page.evaluate(() => document.querySelector('#form').elements[1].value || '')).length > 0 &&
          old.length > 0,
        'the form keeps its values',
      );
    }));

  await test('what is displayed ends at the torque limits, in the sentence and in the picture', async () => {
    const arm =
      '#v1/?page=wanted&mechanism=two_link&mechanism.length_1=1&mechanism.length_2=1&scene=none&desired=given' +
      '&law=no_direct_control&q=0.785398163397,1.570796326795&qd=-0.07,0.14';
    for (const [link, sentence] of [
      [arm + '&Fd=-0.25,0.75', /displays Fd exactly, 0\.791 N: it lies in the green area\.$/],
      [arm + '&Fd=-25,75', /^Direction exact, 2\.24 N of the 79\.1 N: both brakes are at their limit\.$/],
      [arm + '&Fd=-25,75&brakes.torque_limit=0,0', /^No brake has a torque limit above 0/],
      ['#v1/fig4', /^Direction exact, up to 5 N of the 2000 N: brake 2 is .* the hand pushes, now 1\.5 N\.$/],
      ['#v1/five-bar', /50\.3° off .* displays 16 N of the 1570 N needed: brake 1 is at its limit\.$/],
    ])
      await with_page(link, {prepare: keep_saved}, async page => {
        await settle(page);
        const found = await page.locator('#answer').textContent();
        expect(sentence.test(found), link + ' states the displayed force', found);
        const svg = await saved_by(page, '#save_svg'),
          colour = name =>
            page.evaluate(id => getComputedStyle(document.documentElement).getPropertyValue(id).trim(), name);
        const points = pattern =>
          [...(pattern.exec(svg)?.[1] || '').matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(p =>
            p.slice(1).map(Number),
          );
        const [tip] = points(RegExp(`d="([^"]*)" fill="${await colour('--made')}"/>`)),
          area = points(RegExp(`d="([^"]*)" fill="none" stroke="${await colour('--cone-line')}"`));
        const is_inside = [0, 1].every(i => {
          const side = area.map(p => p[i]);
          return !tip || (tip[i] > Math.min(...side) - 1 && tip[i] < Math.max(...side) + 1);
        });
        expect(!!tip === !/^No brake/.test(found) && is_inside, link + ' ends in the green area', tip);
      });
  });

  await test('a link that cannot be opened leaves the page, which states the reason', async () => {
    const device = '#v1/?page=wanted&mechanism=two_link',
      reason = page => page.locator('#warning').textContent();
    await with_page(device + '&law=foo', {}, async page =>
      expect(/law = 'foo', expected one of/.test(await reason(page)), 'the first link', await reason(page)),
    );
    await with_page('#v1/fig2', {}, async page => {
      for (const [link, expected] of [
        ['#v1/fig99', /page = 'fig99', expected watch/],
        ['#v2/fig2', /link = '#v2\/fig2', expected #v1\//],
        ['#v1/%E0%A4', /page = '%E0%A4', expected/],
        ['#v1/?page=foo&mechanism=two_link', /page = 'foo', expected watch/],
        ['#v1/?mechanism=foo', /mechanism = 'foo', expected one of/],
        [
          '#v1/?mechanism=five_bar_4&q=3.1,0',
          /q = '3.1,0', expected joint positions at which the chain closes/,
        ],
        [device + '&foo', /setting = 'foo', expected NAME=VALUE/],
        [device + '&foo=3', /setting = 'foo', expected a name/],
        [device + '&mechanism.length_1=-1', /length_1 \[m\] = -1, expected a finite number > 0/],
        [device + '&q=1,2,3', /expected 2 numbers/],
        [device + '&scene=plane:0,0,0,0', /expected a direction/],
      ]) {
        await page.evaluate(hash => {
          location.hash = hash;
        }, link);
        await settle(page);
        expect(expected.test(await reason(page)), link + ' has its reason', await reason(page));
        expect(
          (await page.evaluate(() => document.body.dataset.question)) === 'forces',
          link + ' opens nothing',
        );
      }
      await page.evaluate(() => {
        location.hash = '#v1/fig3-Fd1';
      });
      await page.waitForFunction(() => document.getElementById('warning').hidden);
      await page.evaluate(() => document.querySelector('.skip').click());
      await page.waitForTimeout(400);
      expect(
        (await page.evaluate(() => location.hash)) === '#v1/fig3-Fd1',
        'the place of the page is no link',
      );
    });
    await with_page('#v1/?page=laws&mechanism=two_link&scene=none&hand=along', {}, async page => {
      await page.waitForFunction(() => /hand = 'along'/.test(document.getElementById('warning').textContent));
    });
  });

  await test('a link with a law that was removed opens with another one, and the page names both', () =>
    with_page('#v1/?page=forces&mechanism=two_link&law=coercive_force_approximation', {}, async page => {
      const warning = await page.locator('#warning').textContent();
      expect(/'coercive_force_approximation' was removed.*: direct_control$/.test(warning), 'the laws', warning);
      expect((await page.locator('#law').inputValue()) === 'direct_control', 'the law of the page');
    }));

  await test('the picture is saved as SVG', () =>
    with_page('#v1/fig2', {prepare: keep_saved}, async page => {
      await settle(page);
      const svg = await saved_by(page, '#save_svg');
      expect(
        svg.startsWith('<svg') && svg.includes('<path') && !/NaN|undefined/.test(svg),
        'an SVG document',
        svg.slice(0, 80),
      );
    }));

  await test('the link follows a device into another question', () =>
    with_page('#v1/forces', {}, async page => {
      await page.selectOption('#mechanism', 'xy_table');
      await page.evaluate(() => {
        location.hash = '#v1/wanted';
      });
      await page.waitForFunction(() => /page=wanted&.*mechanism=xy_table/.test(location.hash));
      expect((await page.evaluate(() => document.body.dataset.question)) === 'wanted', 'the question');
    }));

  await test('every mechanism opens in every question', () =>
    with_page('#v1/forces', {}, async page => {
      const mechanisms = await page
        .locator('#mechanism option')
        .evaluateAll(options => options.map(option => option.value));
      expect(mechanisms.length >= 8, 'mechanisms', mechanisms);
      for (const mechanism of mechanisms) {
        await page.selectOption('#mechanism', mechanism);
        for (const question of ['forces', 'wanted', 'why', 'laws', 'mine']) {
          await page.evaluate(id => {
            location.hash = '#v1/' + id;
          }, question);
          await page.waitForFunction(id => document.body.dataset.question === id, question);
          await page.waitForTimeout(120);
          expect(
            (await page.locator('#mechanism').inputValue()) === mechanism,
            mechanism + ' stays in ' + question,
          );
          expect(
            await page.locator('#refused').isHidden(),
            mechanism + ' in ' + question + ' is not refused',
            await page.locator('#refused').textContent(),
          );
        }
      }
    }));

  if (values_file)
    await test('each preset opens by its link, and each number that is shown is the native one', async () => {
      for (const [preset, values] of native_values(readFileSync(values_file, 'utf8')))
        await with_page('#v1/' + preset, {}, async page => {
          await settle(page);
          expect(
            (await page.locator(`#presets a[data-id="${preset}"][aria-current="page"]`).count()) === 1,
            preset + ' is current',
          );
          if (await page.evaluate(() => document.body.classList.contains('moving'))) return;
          const shown = await page
            .locator('.number')
            .evaluateAll(buttons =>
              buttons.map(button => [button.dataset.id, Number(button.dataset.index), button.dataset.value]),
            );
          expect(shown.length > 30, preset + ' shows numbers', shown.length);
          for (const [id, index, text] of shown) {
            const native = values.get(id)?.[index];
            expect(same_value(id, Number(text), native), `${preset}: ${id}[${index}]`, [text, native]);
          }
        });
    });

  if (browser.name === 'chromium')
    await test('axe finds nothing, in light and dark, wide and as a phone', async () => {
      for (const question of ['watch', 'forces', 'wanted', 'why', 'laws', 'mine'])
        for (const dark of [false, true])
          for (const width of [1280, 390])
            await with_page('#v1/' + question, {width, height: 844, dark}, async page => {
              await page.waitForTimeout(150);
              await page.evaluate(axe_source);
              const found = await page.evaluate(() =>
                window.axe.run(document, {resultTypes: ['violations']}),
              );
              expect(
                found.violations.length === 0,
                `${question}, ${dark ? 'dark' : 'light'}, ${width}`,
                found.violations.map(v => v.id + ': ' + v.nodes.slice(0, 2).map(n => n.html.slice(0, 120))),
              );
            });
    });
}

await test('the page is one file of less than 1.5 MB', async () =>
  expect(statSync(file).size < 1.5e6, 'size', statSync(file).size));
const browser = await open_browser(folder, browser_name);
try {
  await in_browser(browser);
} finally {
  await browser.close();
}
console.log(`${browser_name}: ${passes} checks passed, ${failures} failed`);
process.exit(failures ? 1 : 0);
