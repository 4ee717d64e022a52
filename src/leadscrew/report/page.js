'use strict';
// A block that loses time and its places in the pictures light up together.
for (const one of document.querySelectorAll('[data-place]')) {
  const all = document.querySelectorAll('[data-place="' + one.dataset.place + '"]');
  one.addEventListener('pointerenter', () => all.forEach(place => place.classList.add('shown')));
  one.addEventListener('pointerleave', () => all.forEach(place => place.classList.remove('shown')));
}
(() => {
  const holder = document.getElementById('channels');
  if (!holder) return;
  const data = JSON.parse(holder.textContent);
  const charts = [...document.querySelectorAll('.chart')].map((figure, i) => {
    const channel = data.channels[i];
    const bytes = Uint8Array.from(atob(channel.bins), c => c.charCodeAt(0));
    const step = (channel.high - channel.low) / 65535;
    const plot = figure.querySelector('.plot');
    const cursor = plot.appendChild(document.createElement('i'));
    cursor.className = 'cursor';
    cursor.hidden = true;
    const value = k => channel.low + step * (bytes[2 * k] | bytes[2 * k + 1] << 8);
    return {plot, cursor, count: bytes.length / 4, least: b => value(2 * b), greatest: b => value(2 * b + 1), per: channel.per,
            low: +figure.dataset.low, high: +figure.dataset.high, output: figure.querySelector('output'),
            band: figure.querySelector('.band')};
  });
  const middle = bin => Math.min((bin + 0.5) * data.bin - data.period / 2, data.end);
  const binAt = t => Math.floor((t + data.period / 2) / data.bin + 1e-9);
  const all = document.getElementById('all'), now = document.getElementById('now');
  let from = 0, to = data.end;

  const readable = x => {
    const size = Math.abs(x);
    if (size < 1e-9) return '0';
    const digits = Math.max(0, Math.min(9, 4 - Math.floor(Math.log10(size))));
    return (x < 0 ? '−' : '') + size.toFixed(Math.min(digits, 6));
  };
  const clock = (t, digits) => {
    if (data.end < 120) return t.toFixed(digits) + ' s';
    const s = t.toFixed(digits), whole = Math.floor(+s), rest = s.split('.')[1];
    const two = n => String(n).padStart(2, '0');
    const text = data.end < 7200 ? Math.floor(whole / 60) + ':' + two(whole % 60)
        : Math.floor(whole / 3600) + ':' + two(Math.floor(whole / 60) % 60) + ':' + two(whole % 60);
    return rest ? text + '.' + rest : text;
  };

  const drawBand = chart => {
    const first = Math.max(0, binAt(from) - 1), last = Math.min(chart.count - 1, binAt(to) + 1);
    const group = Math.max(1, Math.ceil((last - first + 1) / 1400));
    const x = (a, b) => (((middle(a) + middle(b)) / 2 - from) / (to - from) * 1000).toFixed(2);
    const y = v => ((chart.high - v) / (chart.high - chart.low) * 100).toFixed(2);
    const upper = [], lower = [];
    for (let a = first; a <= last; a += group) {
      const b = Math.min(a + group - 1, last);
      let least = Infinity, greatest = -Infinity;
      for (let k = a; k <= b; ++k) {
        least = Math.min(least, chart.least(k));
        greatest = Math.max(greatest, chart.greatest(k));
      }
      upper.push(x(a, b) + ' ' + y(greatest));
      lower.push(x(a, b) + ' ' + y(least));
    }
    if (chart.band && upper.length) chart.band.setAttribute('d', 'M' + upper.concat(lower.reverse()).join('L') + 'Z');
  };
  const drawTimes = () => {
    const rough = (to - from) / 5, decade = 10 ** Math.floor(Math.log10(rough)), part = rough / decade;
    const clockStep = [30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14400, 21600, 43200].find(s => rough < 1.4 * s);
    const step = rough > 20 ? clockStep || Math.ceil(rough / 86400) * 86400
        : decade * (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10);
    const digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
    for (const row of document.querySelectorAll('.times')) {
      row.textContent = '';
      for (let t = Math.ceil(from / step - 1e-9) * step; t <= to * (1 + 1e-9); t += step) {
        const tick = row.appendChild(document.createElement('span')), place = (t - from) / (to - from);
        tick.style.left = place * 100 + '%';
        tick.className = place > 0.97 ? 'e' : place < 0.03 ? 'b' : '';
        tick.textContent = clock(t, digits);
      }
    }
  };
  const look = (a, b) => {
    const least = Math.min(data.end, 4 * data.bin);
    if (b - a < least) [a, b] = [(a + b - least) / 2, (a + b + least) / 2];
    from = Math.max(0, a);
    to = Math.min(data.end, b);
    all.hidden = from === 0 && to === data.end;
    charts.forEach(drawBand);
    drawTimes();
  };
  const point = t => {
    const shown = t !== null;
    now.textContent = shown ? clock(t, 3) : '—';
    for (const chart of charts) {
      chart.cursor.hidden = !shown;
      chart.output.textContent = '';
      if (!shown || !chart.count) continue;
      chart.cursor.style.left = (t - from) / (to - from) * 100 + '%';
      const bin = Math.max(0, Math.min(chart.count - 1, binAt(t)));
      const a = readable(chart.least(bin) * chart.per), b = readable(chart.greatest(bin) * chart.per);
      chart.output.textContent = a === b ? a : a + ' … ' + b;
    }
  };

  for (const {plot} of charts) {
    let start = null, pick = null;
    const time = event => {
      const box = plot.getBoundingClientRect();
      return from + Math.max(0, Math.min(1, (event.clientX - box.left) / box.width)) * (to - from);
    };
    const stop = () => {
      if (pick) pick.remove();
      start = pick = null;
    };
    plot.addEventListener('pointermove', event => {
      point(time(event));
      if (start === null) return;
      if (!pick) {
        pick = plot.appendChild(document.createElement('i'));
        pick.className = 'pick';
      }
      const a = Math.min(start, time(event)), b = Math.max(start, time(event));
      pick.style.left = (a - from) / (to - from) * 100 + '%';
      pick.style.width = (b - a) / (to - from) * 100 + '%';
    });
    plot.addEventListener('pointerdown', event => {
      point(time(event));
      if (event.pointerType !== 'mouse' || event.button !== 0) return;
      start = time(event);
      plot.setPointerCapture(event.pointerId);
    });
    plot.addEventListener('pointerup', event => {
      const a = start, b = time(event);
      stop();
      if (a !== null && Math.abs(b - a) > (to - from) / 100) look(Math.min(a, b), Math.max(a, b));
    });
    plot.addEventListener('pointercancel', stop);
    plot.addEventListener('pointerleave', () => { if (start === null) point(null); });
    plot.addEventListener('dblclick', () => look(0, data.end));
  }
  all.addEventListener('click', () => look(0, data.end));
  document.documentElement.classList.add('scripted');
})();
