"use strict";
// The viewer of a comparison: draws both pictures and their difference from the values that the page
// holds, whole 32-bit floats in linear light.

const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);
const canvas = byId("canvas");
const context = canvas.getContext("2d");
const { width, height } = data;

// The inverse of compare/pixel_data.cpp: zlib, byte planes, the picture as a bitwise difference.
async function unpack(text) {
    const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    const planes = new Uint8Array(await new Response(stream).arrayBuffer());
    const count = 3 * width * height;
    const reference = new Uint32Array(count), picture = new Uint32Array(count);
    for (let i = 0; i < count; ++i) {
        for (let k = 3; k >= 0; --k) {
            reference[i] = (reference[i] << 8) | planes[k * count + i];
            picture[i] = (picture[i] << 8) | planes[(4 + k) * count + i];
        }
        picture[i] ^= reference[i];
    }
    return { reference: new Float32Array(reference.buffer), picture: new Float32Array(picture.buffer) };
}

// What is on the screen. `scale` is screen pixels a picture pixel; (left, top) is the place on the
// canvas of the picture's corner; `pixel` is the one whose values are told.
const state = {
    view: "reference", shown: "reference", zoom: 1, left: 0, top: 0, pixel: null,
    slider: 0.5, exposure: 0, scale: data.scale, channel: "largest", fitted: true,
};
let values = null, layers = {}, blinking = 0;

const srgb = (v) => (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);

function asScreen(source) {
    const image = new ImageData(width, height);
    const gain = 2 ** state.exposure;
    for (let i = 0; i < width * height; ++i) {
        for (let c = 0; c < 3; ++c)
            image.data[4 * i + c] = Math.round(255 * srgb(Math.min(Math.max(gain * source[3 * i + c], 0), 1)));
        image.data[4 * i + 3] = 255;
    }
    return image;
}

// picture - reference of the chosen channel, or of the one that differs most.
function signedError(i) {
    const d = [0, 1, 2].map((c) => values.picture[3 * i + c] - values.reference[3 * i + c]);
    if (state.channel !== "largest") return d[Number(state.channel)];
    return d.reduce((most, v) => (Math.abs(v) > Math.abs(most) ? v : most), 0);
}

// The colours of compare/color_scale.hpp.
function diverging(value) {
    if (Number.isNaN(value)) return [255, 0, 255];
    const end = value < 0 ? [0.13, 0.4, 0.67] : [0.7, 0.09, 0.17];
    const t = Math.min(Math.abs(value), 1);
    return end.map((e) => Math.round(255 * (1 + t * (e - 1))));
}

function asDifference() {
    const image = new ImageData(width, height);
    for (let i = 0; i < width * height; ++i) {
        image.data.set(diverging(signedError(i) / state.scale), 4 * i);
        image.data[4 * i + 3] = 255;
    }
    return image;
}

function paint(name) {
    const layer = layers[name] ??= new OffscreenCanvas(width, height);
    const image = name === "difference" ? asDifference() : asScreen(values[name]);
    layer.getContext("2d").putImageData(image, 0, 0);
}

function place(layer) {
    context.drawImage(layer, state.left, state.top, width * state.zoom, height * state.zoom);
}

function draw() {
    const ratio = window.devicePixelRatio || 1;
    const w = Math.round(canvas.clientWidth * ratio), h = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== w || canvas.height !== h) {
        canvas.width = w;
        canvas.height = h;
        if (state.fitted) fit();
    }
    context.imageSmoothingEnabled = false;
    context.clearRect(0, 0, w, h);
    if (state.view === "slider") {
        const x = state.left + state.slider * width * state.zoom;
        place(layers.reference);
        context.save();
        context.beginPath();
        context.rect(x, 0, w, h);
        context.clip();
        place(layers.picture);
        context.restore();
        context.fillStyle = "#000";
        context.fillRect(x - 2, 0, 4, h);
        context.fillStyle = "#fff";
        context.fillRect(x - 1, 0, 2, h);
    } else {
        place(layers[state.shown]);
    }
    if (state.pixel) drawMarker(ratio);
    canvas.dataset.view = state.view;
    canvas.dataset.shown = state.shown;
    byId("zoom").textContent = state.zoom >= 1 ? `${+state.zoom.toFixed(1)}×` : `${Math.round(100 * state.zoom)} %`;
}

function drawMarker(ratio) {
    const side = Math.max(state.zoom, 7 * ratio);
    const x = state.left + (state.pixel.x + 0.5) * state.zoom - side / 2;
    const y = state.top + (state.pixel.y + 0.5) * state.zoom - side / 2;
    context.lineWidth = 3 * ratio;
    context.strokeStyle = "#000";
    context.strokeRect(x, y, side, side);
    context.lineWidth = ratio;
    context.strokeStyle = "#fff";
    context.strokeRect(x, y, side, side);
}

function fit() {
    const room = Math.min(canvas.width / width, canvas.height / height);
    state.zoom = room >= 1 ? Math.floor(room) : room;
    state.left = Math.round((canvas.width - width * state.zoom) / 2);
    state.top = Math.round((canvas.height - height * state.zoom) / 2);
    state.fitted = true;
}

// Keeps the picture's point under (x, y) where it is.
function zoomTo(zoom, x = canvas.width / 2, y = canvas.height / 2) {
    const next = Math.min(Math.max(zoom, 0.1), 128);
    state.left = x - ((x - state.left) * next) / state.zoom;
    state.top = y - ((y - state.top) * next) / state.zoom;
    state.zoom = next;
    state.fitted = false;
    draw();
}

function centerOn(pixel) {
    state.left = canvas.width / 2 - (pixel.x + 0.5) * state.zoom;
    state.top = canvas.height / 2 - (pixel.y + 0.5) * state.zoom;
    state.fitted = false;
}

function select(x, y) {
    state.pixel = { x: Math.min(Math.max(x, 0), width - 1), y: Math.min(Math.max(y, 0), height - 1) };
    const i = state.pixel.y * width + state.pixel.x;
    byId("place").textContent = `(${data.x0 + state.pixel.x}, ${data.y0 + state.pixel.y})`;
    for (let c = 0; c < 3; ++c) {
        const a = values.reference[3 * i + c], b = values.picture[3 * i + c];
        byId(`reference-${c}`).textContent = a.toPrecision(7);
        byId(`picture-${c}`).textContent = b.toPrecision(7);
        byId(`difference-${c}`).textContent = (b - a).toExponential(3);
    }
    draw();
}

function show(view) {
    state.view = view;
    if (view !== "slider" && view !== "blink") state.shown = view;
    document.querySelector(`input[name=view][value=${view}]`).checked = true;
    for (const control of document.querySelectorAll(".difference-control"))
        control.hidden = view !== "difference";
    byId("slider-control").hidden = view !== "slider";
    byId("exposure-control").hidden = view === "difference";
    clearInterval(blinking);
    if (view === "blink") {
        state.shown = state.shown === "picture" ? "reference" : "picture";
        blinking = setInterval(flipShown, 600);
    }
    draw();
}

function flipShown() {
    state.shown = state.shown === "reference" ? "picture" : "reference";
    draw();
}

function flip() {
    show(state.shown === "reference" ? "picture" : "reference");
}

function setScale(exponent) {
    state.scale = 10 ** exponent;
    const text = state.scale.toPrecision(2);
    byId("scale-value").textContent = text;
    byId("legend-low").textContent = `−${text}`;
    byId("legend-high").textContent = `+${text}`;
    paint("difference");
}

function setExposure(stops) {
    state.exposure = stops;
    byId("exposure-value").textContent = `${stops > 0 ? "+" : ""}${stops} stops`;
    paint("reference");
    paint("picture");
}

// A pointer's place in the canvas' own pixels.
function at(event) {
    const box = canvas.getBoundingClientRect();
    const ratio = canvas.width / box.width;
    return { x: (event.clientX - box.left) * ratio, y: (event.clientY - box.top) * ratio };
}

function listenToPointer() {
    let drag = null;
    canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        drag = { ...at(event), left: state.left, top: state.top, moved: false };
    });
    canvas.addEventListener("pointermove", (event) => {
        const p = at(event);
        if (drag) {
            drag.moved ||= Math.hypot(p.x - drag.x, p.y - drag.y) > 3;
            state.left = drag.left + p.x - drag.x;
            state.top = drag.top + p.y - drag.y;
            if (drag.moved) state.fitted = false;
        }
        const x = Math.floor((p.x - state.left) / state.zoom), y = Math.floor((p.y - state.top) / state.zoom);
        if (!drag && x >= 0 && y >= 0 && x < width && y < height) select(x, y);
        else draw();
    });
    canvas.addEventListener("pointerup", () => { drag = null; });
    canvas.addEventListener("wheel", (event) => {
        if (document.activeElement !== canvas && !event.ctrlKey) return;
        event.preventDefault();
        const p = at(event);
        zoomTo(state.zoom * (event.deltaY < 0 ? 1.25 : 0.8), p.x, p.y);
    }, { passive: false });
}

function listenToKeys() {
    const views = ["reference", "picture", "slider", "blink", "difference"];
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    canvas.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        const step = steps[event.key];
        if (views[event.key - 1]) show(views[event.key - 1]);
        else if (event.key === " ") flip();
        else if (event.key === "+" || event.key === "=") zoomTo(state.zoom * 1.5);
        else if (event.key === "-") zoomTo(state.zoom / 1.5);
        else if (event.key === "0") { fit(); draw(); }
        else if (step) moveBy(step, event.shiftKey ? 10 : 1);
        else return;
        event.preventDefault();
    });
}

function moveBy([dx, dy], count) {
    const from = state.pixel ?? { x: width >> 1, y: height >> 1 };
    select(from.x + dx * count, from.y + dy * count);
    const x = state.left + state.pixel.x * state.zoom, y = state.top + state.pixel.y * state.zoom;
    if (x < 0 || y < 0 || x > canvas.width - state.zoom || y > canvas.height - state.zoom) centerOn(state.pixel);
    draw();
}

function listenToControls() {
    for (const input of document.querySelectorAll("input[name=view]"))
        input.addEventListener("change", () => show(input.value));
    byId("zoom-in").addEventListener("click", () => zoomTo(state.zoom * 1.5));
    byId("zoom-out").addEventListener("click", () => zoomTo(state.zoom / 1.5));
    byId("zoom-fit").addEventListener("click", () => { fit(); draw(); });
    byId("zoom-one").addEventListener("click", () => zoomTo(1));
    byId("flip").addEventListener("click", flip);
    byId("slider").addEventListener("input", (event) => {
        state.slider = event.target.value / 100;
        draw();
    });
    byId("exposure").addEventListener("input", (event) => {
        setExposure(Number(event.target.value));
        draw();
    });
    byId("scale").addEventListener("input", (event) => {
        setScale(Number(event.target.value));
        draw();
    });
    byId("channel").addEventListener("change", (event) => {
        state.channel = event.target.value;
        paint("difference");
        draw();
    });
    for (const button of document.querySelectorAll("button.go")) {
        button.addEventListener("click", () => {
            const pixel = { x: button.dataset.x - data.x0, y: button.dataset.y - data.y0 };
            state.zoom = Math.max(state.zoom, 16);
            centerOn(pixel);
            select(pixel.x, pixel.y);
            canvas.scrollIntoView({ block: "center" });
            canvas.focus({ preventScroll: true });
        });
    }
}

// A link to a pixel's details opens them; so does printing.
function openTarget() {
    const target = location.hash && byId(location.hash.slice(1));
    if (target instanceof HTMLDetailsElement) target.open = true;
}

async function start() {
    values = await unpack(byId("values").textContent.trim());
    document.querySelector(".viewer").hidden = false;
    document.documentElement.classList.add("js");
    setExposure(0);
    byId("scale").value = Math.log10(data.scale);
    setScale(Math.log10(data.scale));
    listenToPointer();
    listenToKeys();
    listenToControls();
    new ResizeObserver(draw).observe(canvas);
    show("reference");
    window.addEventListener("hashchange", openTarget);
    openTarget();
    canvas.dataset.ready = "yes";
}

start();
