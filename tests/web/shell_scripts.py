"""What tests of the shell ask a page, in its own language."""

# How many colours each plot shows.
COLOURS = """() => [...document.querySelectorAll('#plots canvas')].map((one) => {
        const copy = new OffscreenCanvas(one.width, one.height).getContext('2d', { willReadFrequently: true });
        copy.drawImage(one, 0, 0);
        const pixels = copy.getImageData(0, 0, one.width, one.height).data;
        const colours = new Set();
        for (let i = 0; i < pixels.length;
            i += 4) if (pixels[i + 3] > 200)
            colours.add(`${pixels[i] >> 5} ${pixels[i + 1] >> 5} ${pixels[i + 2] >> 5}`);
        return colours.size; })"""

# Frames as they would come in many seconds, in bursts between drawings.
FEED = """async (bursts) => {
        const { store } = window.cotouch;
        let last = store.frame;
        for (let burst = 0; burst < bursts; burst++) {
            for (let i = 0; i < 300; i++) {
                const copies = last.copies.map((copy) => ({ ...copy, displacement: copy.displacement.slice() }));
                const { time, number } = last;
                last = { ...last, copies, time: time + 1 / 60, number: number + 1, received: performance.now() };
                store.drawn(last);
            }
            await new Promise((done) => setTimeout(done, 60));
        }
        return store.history.count; }"""

# What can be pressed or set and has no name.
NAMELESS = """() => {
    const roles = ['button', 'checkbox', 'radio', 'tab', 'img'].map((role) => `[role=${role}]`);
    return [...document.querySelectorAll(['button', 'a', 'input', 'select', 'textarea', ...roles].join(','))]
        .filter((one) => !(one.getAttribute('aria-label') || one.textContent.trim() || one.closest('label')))
        .map((one) => one.outerHTML.slice(0, 120)); }"""

# Names of elements that more than one has.
DOUBLED = """() => {
    const all = [...document.querySelectorAll('[id]')].map((one) => one.id);
    return all.filter((id, i) => all.indexOf(id) !== i); }"""

# Where what is seen ends on the right [pixels].
RIGHTMOST = """() => [
    document.documentElement.scrollWidth, ...[...document.querySelectorAll('.layout > *, .panel-body, .tabs')]
                .filter((one) => one.getClientRects().length).map((one) =>
                    Math.ceil(one.getBoundingClientRect().right))]"""

# Parts that are seen.
PANELS = """() => [...document.querySelectorAll('.layout > .panel')].filter((one) => one.getClientRects().length)
    .map((one) => one.id)"""

# What is too small for a finger.
SMALL = """() => [...document.querySelectorAll('button, select, a.button, input')].filter((one) => {
                const { width, height } = one.getBoundingClientRect();
                return width && (width < 24 || height < 22) && !one.closest('table, .skip') &&
                    !one.classList.contains('skip'); }).map((one) => one.outerHTML.slice(0, 90))"""

# How many elements change gradually.
MOVING = """() => [...document.querySelectorAll('*')].filter((one) => parseFloat(getComputedStyle(one)
    .transitionDuration) > 0).length"""

# Contrast of every text that is seen with what is behind it, where that is one colour: [text, contrast].
SEEN = """() => {
    const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    const rgba = (colour) => {
        canvas.clearRect(0, 0, 1, 1); canvas.fillStyle = colour; canvas.fillRect(0, 0, 1, 1);
        return [...canvas.getImageData(0, 0, 1, 1).data].map((value) => value / 255);
    };
    const light = (colour) => colour.slice(0, 3)
        .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4))
        .reduce((sum, value, i) => sum + value * [0.2126, 0.7152, 0.0722][i], 0);
    const over = (top, ground) => top.slice(0, 3).map((value, i) => value * top[3] + ground[i] * (1 - top[3]));
    const ground = (one) => {
        const layers = [];
        for (let at = one; at; at = at.parentElement) {
            const style = getComputedStyle(at);
            if (style.backgroundImage !== 'none') return null;
            const layer = rgba(style.backgroundColor);
            if (layer[3] > 0) layers.push(layer);
            if (layer[3] === 1) return layers.reverse().reduce((below, top) => over(top, below), [1, 1, 1]);
        }
        return null;
    };
    const found = [];
    for (const one of document.querySelectorAll('body *')) {
        const own = [...one.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
        if (!own || one.closest('.unseen, .skip, :disabled, [disabled], svg') || !one.getClientRects().length) continue;
        if (one.closest('label')?.querySelector(':disabled')) continue;
        const below = ground(one);
        if (!below) continue;
        const style = getComputedStyle(one);
        const ink = over(rgba(style.color), below);
        const [x, y] = [light(ink), light(below)].sort((p, q) => q - p);
        const name = `${one.className || one.tagName}: ${one.textContent.trim().slice(0, 30)}`;
        found.push([name, (x + 0.05) / (y + 0.05)]);
    }
    return found; }"""

# Contrast of every pair of text and ground.
CONTRAST = """() => {
    const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    const probe = document.body.appendChild(document.createElement('span'));
    const channels = (colour) => {
        probe.style.color = ''; probe.style.color = colour;
        canvas.fillStyle = getComputedStyle(probe).color; canvas.fillRect(0, 0, 1, 1);
        return [...canvas.getImageData(0, 0, 1, 1).data].slice(0, 3).map((value) => value / 255);
    };
    const light = (colour) => channels(colour)
        .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4))
        .reduce((sum, value, i) => sum + value * [0.2126, 0.7152, 0.0722][i], 0);
    const contrast = (a, b) => { const [x, y] = [light(a), light(b)].sort((p, q) => q - p);
        return (x + 0.05) / (y + 0.05); };
    const pairs = [];
    for (const ground of ['panel', 'paper', 'sunk', 'accent-tint']) pairs.push(['var(--ink)', `var(--${ground})`]);
    for (const ground of ['panel', 'paper', 'sunk']) pairs.push(['var(--muted)', `var(--${ground})`]);
    for (const tone of ['good', 'warn', 'bad', 'accent']) pairs.push([`var(--${tone})`, 'var(--panel)'],
        [`var(--${tone})`, `var(--${tone}-tint)`]);
    pairs.push(['var(--on-accent)', 'var(--accent)'], ['var(--on-bad)', 'var(--bad)'],
        ['var(--panel)', 'var(--ink)']);
    for (let slot = 0; slot < 8; slot++) {
        pairs.push([`var(--on-user-${slot})`, `var(--user-${slot})`]);
        pairs.push([`color-mix(in oklab, var(--user-${slot}) 45%, var(--ink))`, 'var(--panel)']);
    }
    const found = pairs.map(([a, b]) => [a, b, contrast(a, b)]);
    probe.remove();
    return found; }"""
