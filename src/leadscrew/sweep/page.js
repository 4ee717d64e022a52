'use strict';
// A click on the head of a column sorts the table by it, a second one the other way round.
document.documentElement.classList.add('scripted');
for (const table of document.querySelectorAll('table.sorted')) {
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, column) => {
    head.dataset.sorts = '';
    head.tabIndex = 0;
    const sort = () => {
      const falls = head.getAttribute('aria-sort') === 'ascending';
      for (const each of heads) each.removeAttribute('aria-sort');
      head.setAttribute('aria-sort', falls ? 'descending' : 'ascending');
      const value = row => row.cells[column].dataset.value ?? row.cells[column].textContent;
      const order = new Intl.Collator(undefined, {numeric: true}).compare;
      const rows = [...table.tBodies[0].rows];
      const less = (a, b) => {
        const x = Number(a), y = Number(b);
        return Number.isNaN(x) || Number.isNaN(y) ? order(a, b) : x - y;
      };
      rows.sort((a, b) => less(value(a), value(b)) * (falls ? -1 : 1));
      table.tBodies[0].append(...rows);
    };
    head.addEventListener('click', sort);
    head.addEventListener('keydown', event => {
      if (event.key === 'Enter' || event.key === ' ') event.preventDefault(), sort();
    });
  });
}
