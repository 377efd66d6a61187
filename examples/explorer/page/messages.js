// Texts next to the picture: a note, a refusal in the words of the library.

export const by_id = id => document.getElementById(id);

const show_in =
  id =>
  (text = '') =>
    Object.assign(by_id(id), {hidden: !text, textContent: text});
export const say = show_in('note');
export const refuse = show_in('refused');
export const warn = show_in('warning'); // why a link is not opened, or nothing moves
