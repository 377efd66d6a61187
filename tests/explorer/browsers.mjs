// The browsers of this machine, driven by playwright-core, and the pages that they open. playwright-core
// 1.58.0 drives Debian's Firefox by WebDriver BiDi.
import {createRequire} from 'node:module';
import {existsSync} from 'node:fs';
import {resolve} from 'node:path';

const programs = {
  chromium: ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'],
  firefox: ['/usr/bin/firefox-esr', '/usr/bin/firefox'],
};

// A package of npm from a folder with node_modules.
export function load_package(folder, name) {
  return createRequire(resolve(folder) + '/')(name);
}

export const program_of = name => programs[name].find(path => existsSync(path));

// A browser {name, open(file, options), close()}. open() gives {page, messages}, in which all that the
// console got is collected.
export async function open_browser(folder, name) {
  if (!program_of(name)) throw new Error(`no ${name} here, expected one of ${programs[name]}`);
  const playwright = load_package(folder, 'playwright-core');
  const browser =
    name === 'chromium'
      ? await playwright.chromium.launch({executablePath: program_of(name), args: ['--no-sandbox']})
      : await playwright.firefox.launch({
          channel: 'moz-firefox',
          executablePath: program_of(name),
          timeout: 60000,
        });
  return {
    name,
    version: browser.version(),
    async open(address, {width = 1280, height = 900, dark = false, touch = false, prepare} = {}) {
      const context = await browser.newContext({
        viewport: {width, height},
        hasTouch: touch,
        ...(name === 'chromium' ? {colorScheme: dark ? 'dark' : 'light'} : {}),
      });
      const page = await context.newPage(),
        messages = [];
      page.on('console', message => messages.push(message.type() + ': ' + message.text()));
      page.on('pageerror', error => messages.push('error: ' + error.message));
      page.on('request', request => {
        if (/^(https?|ws):/.test(request.url())) messages.push('request: ' + request.url());
      });
      if (prepare) await page.addInitScript(prepare);
      await page.goto(address);
      await page.waitForFunction(() => document.documentElement.dataset.ready === 'true', null, {
        timeout: 60000,
      });
      if (dark)
        await page.evaluate(() => {
          document.documentElement.dataset.theme = 'dark';
        });
      return {page, messages, close: () => context.close()};
    },
    close: () => browser.close(),
  };
}
