// The colours of the drawing, as the style sheet names them: light and dark have one source.

const theme_names = (
  'paper ink muted faint metal wall wall_line cone cone_line wanted made motion hand result slips holds released ' +
  'slips_text holds_text law_1 law_2 law_3'
).split(' ');

export function read_theme() {
  const style = getComputedStyle(document.documentElement),
    theme = {};
  for (const name of theme_names) theme[name] = style.getPropertyValue('--' + name.replaceAll('_', '-')).trim();
  theme.laws = [theme.law_1, theme.law_2, theme.law_3];
  return theme;
}

// Calls back when light and dark change, by the system or by the visitor.
export function watch_theme(changed) {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', changed);
  new MutationObserver(changed).observe(document.documentElement, {attributes: true, attributeFilter: ['data-theme']});
}
