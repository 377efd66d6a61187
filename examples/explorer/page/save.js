// Files that the visitor takes along: the picture as SVG or PNG, the record as a log.

// content: a text or a Blob.
export function save_file(name, content, type) {
  const link = document.createElement('a'),
    address = URL.createObjectURL(new Blob([content], {type}));
  Object.assign(link, {href: address, download: name});
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

// Calls take(text, name) with each file that is dropped on the page or chosen in an input.
export function watch_files(page, input, take) {
  const read = async file => {
    if (file) take(await file.text(), file.name);
  };
  input.addEventListener('change', () => {
    read(input.files[0]);
    input.value = '';
  });
  page.addEventListener('dragover', event => {
    event.preventDefault();
    page.classList.add('dropping');
  });
  page.addEventListener('dragleave', event => {
    if (!event.relatedTarget) page.classList.remove('dropping');
  });
  page.addEventListener('drop', event => {
    event.preventDefault();
    page.classList.remove('dropping');
    read(event.dataTransfer.files[0]);
  });
}
