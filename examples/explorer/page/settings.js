// The settings of a device as a map from name to text, read from and written to the engine's lines
// "NAME=VALUE", and the link that carries them: "#v1/PRESET" or "#v1/?NAME=VALUE&NAME=VALUE".

const link_version = 'v1';

// A Map of the lines of a text.
export function parse_settings(text) {
  const settings = new Map();
  for (const line of text.split('\n')) {
    const at = line.indexOf('=');
    if (at > 0) settings.set(line.slice(0, at).trim(), line.slice(at + 1).trim());
  }
  return settings;
}

export function format_settings(settings) {
  return [...settings].map(([name, value]) => name + '=' + value).join('\n');
}

// What a link names: {page}, {settings} or, of an address without one, {}; else the {reason} why it is none.
export function parse_link(hash) {
  if (hash.length < 2) return {};
  const match = /^#v1\/(.+)$/s.exec(hash);
  if (!match) return {reason: `link = ${quoted(hash)}: expected #${link_version}/ and a page or settings`};
  if (!match[1].startsWith('?')) return {page: safe_decode(match[1])};
  const settings = new Map();
  for (const part of match[1].slice(1).split('&')) {
    const at = part.indexOf('=');
    if (at < 0 && part) return {reason: `setting = ${quoted(safe_decode(part))}: expected NAME=VALUE`};
    if (part) settings.set(safe_decode(part.slice(0, at)), safe_decode(part.slice(at + 1)));
  }
  return {settings};
}

// The start of a text that is not ours, for a message.
export const quoted = text => "'" + text.slice(0, 80) + "'";

export function settings_link(settings) {
  const encode = text => encodeURIComponent(text).replace(/%2C/g, ',').replace(/%3A/g, ':');
  return '#' + link_version + '/?' + [...settings].map(([name, value]) => encode(name) + '=' + encode(value)).join('&');
}

export function page_link(page) {
  return '#' + link_version + '/' + encodeURIComponent(page);
}

// The whole address of a page, for links: a reader of the screen then does not take it for a place of this
// page.
export function page_address(page) {
  return location.href.split('#')[0] + page_link(page);
}

function safe_decode(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
