// The link of what is shown, which the address bar follows.

import {app} from './app.js';
import {page_link, parse_settings, settings_link} from './settings.js';

// The link follows what is shown, without an entry in the history, unless another one was followed meanwhile.
let link_timer = 0;
export function keep_link() {
  const {hash} = location;
  clearTimeout(link_timer);
  link_timer = setTimeout(() => location.hash === hash && history.replaceState(null, '', own_link()), 300);
}

function own_link() {
  if (app.preset) return page_link(app.preset.id);
  if (!app.is_own && !app.is_moved) return page_link(app.question.id);
  const settings = parse_settings(app.device.settings());
  return settings_link(new Map([['page', app.question.id], ...settings]));
}
