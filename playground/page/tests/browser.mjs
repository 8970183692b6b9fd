// The page in a real browser: `node tests/browser.mjs PAGE COMMAND SHOTS`. PAGE is the HTML file, COMMAND the command `denhart`.
//
// The browser is CHROMIUM [default: /usr/bin/chromium]. Every test opens the page anew, from a file.

import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { request } from "node:http";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [pageFile, command, shots] = process.argv.slice(2).map((path) => resolve(path));
const root = resolve(import.meta.dirname, "../../..");
const address = pathToFileURL(pageFile).href;
mkdirSync(shots, { recursive: true });

const FLAGS = ["--no-sandbox", "--disable-quic", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--no-first-run"];
const WITH_3D = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const launch = (flags) => chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: [...FLAGS, ...flags] });

const denhart = (...words) => execFileSync(command, words, { cwd: root, encoding: "utf8" });
const near = (a, b, within, what) => assert.ok(Math.abs(a - b) <= within, `${what}: ${a} and ${b}`);

/** Opens the page and waits until it is ready. */
async function open(browser, { url = address, width = 1400, height = 900 } = {}) {
  const page = await browser.newPage({ viewport: { width, height }, colorScheme: "light" });
  page.requests = [];
  page.failures = [];
  page.on("request", (of) => page.requests.push(of.url()));
  page.on("pageerror", (error) => page.failures.push(error.message));
  page.on("console", (line) => line.type() === "error" && page.failures.push(line.text()));
  await page.goto(url);
  await page.waitForSelector("body.is-ready", { timeout: 30000 });
  return page;
}

/** The state of the page. */
const state = (page) =>
  page.evaluate(() => {
    const { app, view } = window.denhart;
    const { q, target, text, messages, here, given, times, branches, miss } = app;
    return {
      q, target, text, messages, here, given, times, branches, miss, name: app.facts?.name,
      solutions: app.answer?.solutions.map(({ q, flags }) => ({ q, flags })), status: app.answer?.status,
      tool: app.figure?.tool, seen: view?.read(),
    };
  });

/** Puts a text into the editor, as one who pastes it. */
async function paste(page, text) {
  await page.locator("#editor .cm-content").click();
  await page.keyboard.press("Control+A");
  await page.evaluate((text) => {
    const data = new DataTransfer();
    data.setData("text/plain", text);
    document.querySelector("#editor .cm-content").dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  }, text);
}

async function drop(page, name, text) {
  const data = await page.evaluateHandle(([name, text]) => {
    const data = new DataTransfer();
    data.items.add(new File([text], name));
    return data;
  }, [name, text]);
  await page.dispatchEvent("#view", "drop", { dataTransfer: data });
}

const until = (page, check, of) => page.waitForFunction(check, of, { timeout: 20000 });

/** Chooses an arm from the gallery. */
async function choose(page, name) {
  await page.click("#presets");
  await page.fill("#gallery-search", name);
  await page.click(`.card[data-name="${name}"]`);
  await until(page, (name) => window.denhart.app.facts?.name === name && !document.querySelector("dialog[open]"), name);
}

/** Drags the mouse in steps. */
async function drag(page, [x, y], [dx, dy]) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= 12; step++) await page.mouse.move(x + (dx * step) / 12, y + (dy * step) / 12);
  await page.mouse.up();
}

const yaml = (rows, more = "") => `name: typed\nconvention: standard\nunits: {length: m, angle: deg}\n${more}joints:\n${rows.map((row) => `  - {${row}}\n`).join("")}`;

/** The command serves a file, which it may write: the file, the command, the address. */
async function serve(text) {
  const file = join(mkdtempSync(join(tmpdir(), "denhart-view-")), "arm.yaml");
  writeFileSync(file, text);
  const server = spawn(command, ["view", file, "--no-open", "--write"], { stdio: ["ignore", "pipe", "inherit"] });
  const url = await new Promise((done, failed) => {
    server.stdout.once("data", (data) => done(String(data).split("\n")[0]));
    server.once("exit", () => failed(new Error("the server ended")));
  });
  return [file, server, url];
}

const tests = {
  async "loads and asks no other host"(browser) {
    const page = await open(browser);
    const first = await page.evaluate(() => performance.getEntriesByName("first picture")[0].startTime);
    console.log(`    first picture after ${Math.round(first)} ms`);
    await page.waitForTimeout(1500);
    const { name, seen, solutions } = await state(page);
    assert.equal(name, "ur5");
    assert.equal(solutions.length, 8);
    assert.equal(seen.ghosts, 8);
    assert.equal(new Set(seen.ghostColors).size, 8);
    const shown = await page.locator("#panel-rust .cm-content").innerText();
    assert.ok(shown.includes("pub struct Ur5;"), shown.slice(0, 400));
    await page.screenshot({ path: join(shots, "start.png") });
    assert.deepEqual(page.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
    assert.deepEqual(page.failures, []);
  },

  async "a mistake is told in its place while it is typed"(browser) {
    const page = await open(browser);
    const before = await state(page);
    await page.locator("#editor .cm-line", { hasText: "-0.425" }).click();
    await page.keyboard.press("End");
    await page.keyboard.type(" wrong");
    await until(page, () => document.querySelectorAll("#messages .message.error").length > 0);
    await page.keyboard.press("Control+Z");
    await until(page, () => document.querySelectorAll("#messages .message.error").length === 0);
    await paste(page, before.text.replace("alpha: 90, d: 0.089159", "alfa: 90, d: 0.089159"));
    await until(page, () => window.denhart.app.messages.some((one) => one.message.includes("alfa")));
    const message = await page.locator("#messages .message.error").first().innerText();
    assert.match(message, /line 8: unknown key `alfa`/);
    const marked = await page.locator("#editor .cm-lintRange-error").first().innerText();
    assert.equal(marked, "alfa");
    await page.screenshot({ path: join(shots, "mistake.png") });
    // The picture stays that of the last right text.
    assert.equal((await state(page)).seen.ghosts, 8);
    await page.locator("#messages .message.error").first().click();
    assert.ok(await page.evaluate(() => document.activeElement.closest("#editor") !== null));
    // Completion of the schema.
    await paste(page, "con");
    await page.keyboard.press("End");
    await page.keyboard.press("Control+Space");
    await page.waitForSelector(".cm-tooltip-autocomplete");
    assert.match(await page.locator(".cm-tooltip-autocomplete").innerText(), /convention/);
  },

  async "a slider gives the pose of the command"(browser) {
    const page = await open(browser);
    await choose(page, "puma560");
    await choose(page, "ur5");
    const values = [10, -60, 80, -30, 45, 20];
    for (const [joint, value] of values.entries()) {
      await page.locator("#sliders input[type=range]").nth(joint).fill(String(value));
    }
    const { tool, q, seen, times } = await state(page);
    q.forEach((value, joint) => near((value * 180) / Math.PI, values[joint], 1e-9, `q${joint + 1}`));
    const told = JSON.parse(denhart("forward", "specs/ur5.yaml", "--q", values.join(" "), "--json"));
    told.pose.position.forEach((value, axis) => near(tool[9 + axis], value, 1e-12, "position"));
    const rotation = told.pose.matrix.slice(0, 3).flatMap((row) => row.slice(0, 3));
    rotation.forEach((value, entry) => near(tool[entry], value, 1e-12, "rotation"));
    assert.equal(seen.ghosts, 8);
    console.log(`    handler of a slider: median ${median(times).toFixed(2)} ms, longest ${Math.max(...times).toFixed(2)} ms`);
    // The numbers of the tab are those of the arm.
    await page.click("#tab-pose");
    assert.ok((await page.locator("#panel-pose").innerText()).includes(String(Number(tool[9].toFixed(6)))));
    await page.screenshot({ path: join(shots, "pose.png") });
  },

  async "joints are drawn on their axes"(browser) {
    const page = await open(browser);
    await page.click("#zero");
    await page.waitForTimeout(200);
    const { seen } = await state(page);
    const { home } = JSON.parse(denhart("check", "specs/ur5.yaml", "--json"))[0] ?? {};
    const told = home ?? JSON.parse(denhart("check", "specs/ur5.yaml", "--json")).home;
    // The way from space to the screen, by the camera's matrices alone.
    const { view, projection, width, height } = await page.evaluate(() => {
      const { camera } = window.denhart.view;
      const { width, height } = document.getElementById("view").getBoundingClientRect();
      return { view: camera.matrixWorldInverse.elements, projection: camera.projectionMatrix.elements, width, height };
    });
    const times = (m, v) => [0, 1, 2, 3].map((row) => [0, 1, 2, 3].reduce((sum, column) => sum + m[4 * column + row] * v[column], 0));
    const seenAt = (point) => {
      const [x, y, , w] = times(projection, times(view, [...point, 1]));
      return [((x / w + 1) / 2) * width, ((1 - y / w) / 2) * height];
    };
    told.axes.forEach(({ point, direction }, joint) => {
      const [a, b] = [seenAt(point), seenAt(point.map((value, axis) => value + 0.3 * direction[axis]))];
      const [x, y] = seen.joints[joint];
      const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
      const off = length < 1 ? Math.hypot(x - a[0], y - a[1]) : Math.abs((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / length;
      assert.ok(off < 1, `joint ${joint + 1} is ${off} px off its axis`);
    });
  },

  async "the axes that decide the inverse are drawn, and move with the joints"(browser) {
    const page = await open(browser);
    const all = (q) => page.evaluate((q) => window.denhart.app.moveTo(q), q);
    const space = () => page.evaluate(() => window.denhart.view.axes.read());
    const off = ([x, y], [[ax, ay], [bx, by]]) => Math.abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / Math.hypot(bx - ax, by - ay);
    // Words are placed when the picture is drawn.
    const told = (...words) => page.waitForFunction(
      (words) => [...document.querySelectorAll("#labels .axes:not([hidden])")].map((one) => one.textContent).toSorted().join("; ") === words,
      words.toSorted().join("; "),
    );
    assert.deepEqual((await state(page)).seen.axes, []);
    // A UR5: three parallel axes, through joints 2, 3 and 4.
    await page.locator("#view canvas").focus();
    await page.keyboard.press("a");
    assert.ok(await page.locator("#show-axes").isChecked());
    assert.match(await page.locator("#axes-switch").getAttribute("title"), /axes 2, 3, 4 are parallel$/);
    const directions = [];
    for (const q of [[10, -60, 80, -30, 45, 20], [100, -20, 60, 70, -45, 0]]) {
      await all(q.map((value) => (value * Math.PI) / 180));
      const { seen } = await state(page);
      assert.deepEqual([seen.axes.length, seen.meet.length], [3, 0]);
      seen.axes.forEach((ends, index) => assert.ok(off(seen.joints[index + 1], ends) < 0.5, `joint ${index + 2} is off its axis`));
      const [first, ...others] = (await space()).lines.map(([from, to]) => {
        const way = to.map((value, axis) => value - from[axis]);
        return way.map((value) => value / Math.hypot(...way));
      });
      for (const other of others) near(Math.abs(first.reduce((sum, value, axis) => sum + value * other[axis], 0)), 1, 1e-9, "parallel");
      directions.push(first);
    }
    near(directions[0][0] * directions[1][0] + directions[0][1] * directions[1][1], 0, 1e-6, "the axes turn with joint 1");
    await told("axes 2, 3, 4 are parallel");
    await page.click("#frame");
    await page.waitForTimeout(300);
    await page.screenshot({ path: join(shots, "axes-parallel.png") });
    // An IRB 2400: its wrist meets where joints 5 and 6 stand, and only the first three joints move that point.
    await choose(page, "abb_irb2400");
    const wrist = async (q) => {
      await all(q);
      const { seen } = await state(page);
      assert.deepEqual([seen.axes.length, seen.meet.length], [3, 1]);
      for (const joint of [4, 5]) near(Math.hypot(...seen.meet[0].map((value, at) => value - seen.joints[joint][at])), 0, 0.5, `joint ${joint + 1}`);
      seen.axes.forEach((ends, index) => {
        assert.ok(off(seen.joints[index + 3], ends) < 0.5, `joint ${index + 4} is off its axis`);
        assert.ok(off(seen.meet[0], ends) < 0.5, `axis ${index + 4} goes past the point`);
      });
      return (await space()).points[0];
    };
    const [here, turned, away] = [await wrist([0.3, 0.2, 0.1, 0.4, 0.5, 0.6]), await wrist([0.3, 0.2, 0.1, -1, 0.9, 2]), await wrist([0.9, 0.2, 0.1, 0.4, 0.5, 0.6])];
    const apart = (a, b) => Math.hypot(...a.map((value, axis) => value - b[axis]));
    const size = Math.hypot(...here);
    assert.ok(apart(here, turned) < 1e-5 * size && apart(here, away) > 0.1 * size);
    await told("axes 4, 5, 6 meet in a point");
    await page.screenshot({ path: join(shots, "axes-meet.png") });
    // Two axes that meet and two that are parallel; virtual axes alone; none.
    for (const [name, lines, points, words] of [
      ["kinova_gen3_lite", 4, 1, ["axes 4 and 5 meet", "axes 2 and 3 are parallel"]],
      ["scara_rrrp_325_275", 3, 0, ["axes 1, 2, 3 are parallel"]],
      ["anthro3r", 0, 0, ["no axis of the arm decides this inverse: axes v1, v2, v3 meet in a point, all of them virtual"]],
      ["singular_6r", 0, 0, ["no inverse that axes decide"]],
    ]) {
      await choose(page, name);
      const { seen } = await state(page);
      assert.deepEqual([seen.axes.length, seen.meet.length], [lines, points], name);
      await told(...words);
      await page.screenshot({ path: join(shots, `axes-${name}.png`) });
    }
    await page.locator("#show-axes").uncheck();
    assert.deepEqual((await state(page)).seen.axes, []);
    await told();
    assert.deepEqual(page.failures, []);
    // The words fit on a phone.
    const phone = await open(browser, { width: 390, height: 800 });
    await choose(phone, "anthro3r");
    await phone.locator("#show-axes").check();
    await phone.waitForSelector("#labels .axes:visible");
    await phone.waitForTimeout(400);
    const [box, label] = [await phone.locator("#view").boundingBox(), await phone.locator("#labels .axes").boundingBox()];
    assert.ok(label.x >= box.x && label.x + label.width <= box.x + box.width, JSON.stringify([box, label]));
    for (const other of await phone.locator("#labels .joint:visible").all()) {
      const joint = await other.boundingBox();
      const apart = joint.y >= label.y + label.height || joint.y + joint.height <= label.y || joint.x >= label.x + label.width || joint.x + joint.width <= label.x;
      assert.ok(apart, `a name lies on the words: ${JSON.stringify([joint, label])}`);
    }
    await phone.screenshot({ path: join(shots, "phone-axes.png") });
    await choose(phone, "abb_irb2400");
    await phone.waitForTimeout(200);
    await phone.screenshot({ path: join(shots, "phone-axes-meet.png") });
    await phone.close();
  },

  async "the arm follows a target within its rates"(browser) {
    const page = await open(browser);
    // A far target: from where the arm stands, joint 1 turned by 2 rad.
    const [before, goal] = await page.evaluate(() => {
      const { app } = window.denhart;
      const q = Array.from(app.q);
      app.moveTo(q.map((value, joint) => (joint === 0 ? value + 2 : value)));
      const goal = { q: Array.from(app.q), pose: Array.from(app.target) };
      app.moveTo(q);
      return [q, goal];
    });
    await page.locator("#follow").check();
    const run = await page.evaluate(async ({ pose }) => {
      const { app } = window.denhart;
      const steps = [];
      const start = performance.now();
      let last = Array.from(app.q);
      app.listen(() => {
        const now = Array.from(app.q);
        steps.push(Math.max(...now.map((value, joint) => Math.abs(value - last[joint]))));
        last = now;
      });
      app.aim(pose);
      const jump = steps.at(-1);
      const says = document.getElementById("tracking");
      const seen = new Set();
      while (says.textContent !== "exact" && performance.now() - start < 20000) {
        seen.add(says.textContent.split(":")[0]);
        await new Promise((done) => requestAnimationFrame(done));
      }
      return { jump, most: Math.max(...steps), moves: steps.filter((step) => step > 0).length, seen: [...seen] };
    }, goal);
    const after = await state(page);
    assert.equal(run.jump, 0, "the arm jumps to no solution");
    // A frame has at most 50 ticks of 1 ms, at 3 rad/s where the file says nothing.
    assert.ok(run.most <= 0.15 + 1e-9, `a frame moves a joint by ${run.most}`);
    assert.ok(run.moves >= 10 && run.seen.includes("rates"), JSON.stringify(run));
    assert.equal(await page.locator("#tracking").textContent(), "exact");
    near(after.tool[9], goal.pose[9], 1e-9, "x of the tool");
    assert.ok(Math.abs(after.q[0] - before[0]) > 1, "joint 1 has turned");
    // Out of reach the arm comes to rest, and says so.
    await page.evaluate((pose) => window.denhart.app.aim(pose.map((value, place) => (place < 9 ? value : 10 * value))), goal.pose);
    await page.waitForFunction(() => document.getElementById("tracking").textContent.startsWith("reach"), null, { timeout: 20000 });
    await page.screenshot({ path: join(shots, "follow.png") });
    // A solution that is taken is where it goes on from.
    await page.evaluate((pose) => window.denhart.app.aim(pose), goal.pose);
    await page.evaluate(() => window.denhart.app.choose(1));
    await page.waitForFunction(() => document.getElementById("tracking").textContent === "exact", null, { timeout: 20000 });
    await page.locator("#follow").uncheck();
    assert.equal(await page.locator("#tracking").textContent(), "");
    // A start outside the limits is told once, and the arm jumps again.
    await page.locator("#follow").check();
    const other = await page.evaluate(async (text) => {
      const { app } = window.denhart;
      await app.setText(text);
      const pose = Array.from(app.target);
      app.moveTo(app.q.map((value, joint) => (joint === 1 ? 7 : value)));
      app.aim(pose);
      return pose;
    }, readFileSync(join(root, "specs/abb_irb120.yaml"), "utf8"));
    await page.waitForFunction(() => document.getElementById("notices").textContent.includes("cannot follow"));
    assert.equal(await page.locator("#follow").isChecked(), false);
    await page.evaluate((pose) => window.denhart.app.aim(pose), other);
    near((await state(page)).tool[9], other[9], 1e-9, "the arm jumps");
  },

  async "the target is dragged with eight ghosts, and one is taken"(browser) {
    const page = await open(browser);
    // Well within the workspace of all eight.
    await page.evaluate(() => window.denhart.app.moveTo([10, -60, 80, -30, 45, 20].map((value) => (value * Math.PI) / 180)));
    const before = await state(page);
    await page.click("#frame");
    // The handles stand where they were drawn last.
    await page.waitForTimeout(500);
    await page.evaluate(() => (window.denhart.app.times.length = 0));
    const box = await page.locator("#view").boundingBox();
    const [x, y] = await page.evaluate(() => {
      const { app, view } = window.denhart;
      return view.project(app.target.slice(9, 12));
    });
    await drag(page, [box.x + x, box.y + y], [24, -16]);
    const after = await state(page);
    const moved = Math.hypot(...[9, 10, 11].map((at) => after.target[at] - before.target[at]));
    assert.ok(moved > 0.01, `the target moved by ${moved}`);
    assert.equal(after.seen.ghosts, 8);
    assert.equal(after.solutions.length, 8);
    near(after.tool[9], after.target[9], 1e-9, "the arm follows");
    assert.ok(after.times.length > 5);
    console.log(`    handler of the target with eight ghosts: median ${median(after.times).toFixed(2)} ms, longest ${Math.max(...after.times).toFixed(2)} ms`);
    await page.locator(".solution").nth(2).hover();
    await page.screenshot({ path: join(shots, "ghosts.png") });
    await page.locator(".solution").nth(2).click();
    const taken = await state(page);
    taken.q.forEach((value, joint) => near(value, after.solutions[2].q[joint], 1e-12, "taken"));
    assert.equal(await page.locator(".solution").nth(2).getAttribute("aria-pressed"), "true");
    // A number in the picture takes its solution, too.
    await page.locator("#labels .ghost").nth(5).click();
    (await state(page)).q.forEach((value, joint) => near(value, after.solutions[5].q[joint], 1e-12, "taken in the picture"));
    await page.click("#undo");
    (await state(page)).q.forEach((value, joint) => near(value, taken.q[joint], 1e-9, "undone"));
    // Turned by its numbers.
    await page.getByLabel("target roll").fill("80");
    await page.keyboard.press("Enter");
    assert.equal((await state(page)).seen.ghosts, 8);
  },

  async "a singular posture has a slider along its family"(browser) {
    const page = await open(browser);
    await choose(page, "puma560");
    await page.evaluate(() => window.denhart.app.moveTo([0.3, -0.5, 0.4, 0.2, 0, 0.1]));
    const before = await state(page);
    assert.notEqual(before.here.free, 0);
    assert.equal(await page.locator("#family input[type=range]").count(), 1);
    await page.screenshot({ path: join(shots, "singular.png") });
    await page.locator("#family input[type=range]").fill("50");
    const after = await state(page);
    near(after.q[3] + after.q[5], before.q[3] + before.q[5], 1e-9, "the sum of the wrist's angles");
    assert.ok(Math.abs(after.q[3] - before.q[3]) > 0.1);
    after.tool.forEach((value, entry) => near(value, before.tool[entry], 1e-9, "the tool stays"));
    // The links have the color of a singularity, and lose it away from one.
    const link = () => page.evaluate(() => {
      const { rods } = window.denhart.view.arm;
      const color = { r: 0, g: 0, b: 0, setRGB() {}, fromArray(array, at) { [this.r, this.g, this.b] = array.slice(at, at + 3); return this; } };
      rods.getColorAt(0, color);
      return [color.r, color.g, color.b];
    });
    const singular = await link();
    await page.locator("#family input[type=range]").blur();
    await page.evaluate(() => window.denhart.app.moveTo([0.3, -0.5, 0.4, 0.2, 0.9, 0.1]));
    const [red, , blue] = await link();
    assert.ok(singular[0] - singular[2] > 0.5 && red - blue < 0.1, `${singular} and ${[red, blue]}`);
    assert.equal(await page.locator("#family-part").isVisible(), false);
  },

  async "limits are red"(browser) {
    const page = await open(browser);
    await paste(page, yaml(["a: 0.4, alpha: 0, d: 0, theta: 0, limits: [-30, 30]", "a: 0.3, alpha: 0, d: 0, theta: 0"]));
    await until(page, () => window.denhart.app.facts?.name === "typed");
    const at = async (q) => {
      await page.evaluate((q) => window.denhart.app.moveTo(q), q);
      return (await state(page)).seen.jointColors;
    };
    const [inside] = await at([0.2, 0.7]);
    const [outside, other] = await at([1.2, 0.7]);
    assert.notEqual(inside, outside);
    assert.equal(outside, "#d01c2e");
    assert.equal(other, inside);
    assert.ok(await page.locator("#sliders .slider.outside").count() === 1);
  },

  async "the stepper arm tells its pulses and the lines that would be sent"(browser) {
    const page = await open(browser);
    await choose(page, "salman_rrr");
    await page.locator("#sliders input[type=range]").nth(0).fill("30");
    await page.locator("#sliders input[type=range]").nth(0).dispatchEvent("change");
    const counts = (await page.locator("#counts").innerText()).match(/-?\d+(?= {3}|$)/g).map(Number);
    assert.equal(counts.length, 3);
    // One pulse is the resolution: the counts are those of the angles.
    const line = (await page.locator("#lines li").last().innerText()).trim();
    const [words, sum] = line.split("*");
    assert.equal(words, `MOVE ${counts.join(" ")}`);
    assert.equal(Number.parseInt(sum, 16), [...words].reduce((all, letter) => all ^ letter.charCodeAt(0), 0));
    const before = await page.locator("#lines li").count();
    // Every solution for the point, those out of limits crossed out.
    const { solutions } = await state(page);
    assert.ok(solutions.length >= 2, String(solutions.length));
    const outside = solutions.filter(({ flags }) => flags & 16).length;
    assert.equal(await page.locator(".solution.outside").count(), outside);
    await page.locator(".solution").nth(1).click();
    assert.equal(await page.locator("#lines li").count(), before + 1);
    await page.screenshot({ path: join(shots, "pulses.png") });
  },

  async "a URDF that is dropped becomes an arm file"(browser) {
    const page = await open(browser);
    const urdf = readFileSync(join(root, "cli/tests/urdf/kuka_kr6_r700.urdf"), "utf8");
    await drop(page, "kuka_kr6_r700.urdf", urdf);
    await page.waitForSelector("#imported[open]");
    const { name, solutions } = await state(page);
    assert.match(name, /kr6/);
    assert.ok(solutions.length > 0);
    const told = denhart("import", "cli/tests/urdf/kuka_kr6_r700.urdf");
    assert.equal((await state(page)).text, told);
    await page.locator("#imported button").click();
    await drop(page, "broken.urdf", "<robot name='a'><link name='b'>");
    await page.waitForSelector(".notice.mistake");
    assert.equal((await state(page)).text, told);
  },

  async "a link opens arm, joints and target"(browser) {
    const page = await open(browser);
    await choose(page, "staubli_tx40");
    await page.locator("#sliders input[type=range]").nth(1).fill("33");
    const before = await state(page);
    await page.click("#share");
    await until(page, () => location.hash.startsWith("#v1."));
    const url = page.url();
    console.log(`    link of ${url.length - address.length} letters`);
    const other = await open(browser, { url });
    const after = await state(other);
    assert.equal(after.text, before.text);
    after.q.forEach((value, joint) => near(value, before.q[joint], 1e-12, "joint"));
    after.target.forEach((value, entry) => near(value, before.target[entry], 1e-12, "target"));
    for (const bad of ["#v1.", "#v1.AAAA", "#v1.%%%", "#v2.abc"]) {
      const wrong = await open(browser, { url: address + bad });
      assert.equal((await state(wrong)).name, "ur5", bad);
      assert.deepEqual(wrong.failures, []);
      await wrong.close();
    }
  },

  async "a row marks its numbers in the code and in the picture, and back"(browser) {
    const page = await open(browser);
    await until(page, () => document.querySelector("#panel-rust").innerText.includes("0.425"));
    await page.locator("#editor .cm-line", { hasText: "-0.425" }).hover({ position: { x: 60, y: 6 } });
    await until(page, () => document.querySelectorAll(".marked-number").length > 0);
    assert.equal(await page.locator(".marked-number").first().innerText(), "0.425");
    assert.match(await page.locator("#labels .measure.strong").innerText(), /a2 -0.425 m/);
    await page.screenshot({ path: join(shots, "marked.png") });
    await page.locator("#sliders .slider").nth(0).hover();
    const number = page.locator("#panel-rust .cm-line", { hasText: "const A3" });
    const box = await number.boundingBox();
    await page.mouse.move(box.x + 20, box.y + 5);
    const token = await number.locator("span", { hasText: "0.39225" }).last().boundingBox();
    await page.mouse.move(token.x + token.width / 2, token.y + token.height / 2);
    await until(page, () => window.denhart.app.marked === 2);
    assert.match(await page.locator("#editor .marked-row").innerText(), /-0.39225/);
  },

  async "bad input is told, and the page goes on"(browser) {
    const page = await open(browser);
    const good = (await state(page)).text;
    const told = async () => {
      await until(page, () => window.denhart.app.messages.some((one) => one.severity === "error"));
      return (await state(page)).messages[0].message;
    };
    const right = async (name) => until(page, (name) => window.denhart.app.facts?.name === name && window.denhart.app.messages.length === 0, name);
    await paste(page, `${good}${"# more and more\n".repeat(65000)}`);
    assert.match(await told(), /no arm file is longer/);
    await paste(page, good.replace("0.089159", ".nan"));
    await until(page, () => window.denhart.app.messages.some((one) => one.line === 8));
    await paste(page, good.replace("0.089159", "1e999"));
    await until(page, () => window.denhart.app.messages.some((one) => one.line === 8));
    await paste(page, "[".repeat(5000));
    await until(page, () => window.denhart.app.messages.some((one) => one.severity === "error" && one.line !== 8));
    await paste(page, good);
    await right("ur5");
    // A number that is none leaves the arm where it is.
    const { q } = await state(page);
    await page.evaluate(() => {
      const field = document.querySelector("#sliders input[type=number]");
      field.value = "NaN";
      field.dispatchEvent(new Event("change"));
      window.denhart.app.moveTo([NaN, 0, 0, 0, 0, 0]);
    });
    assert.deepEqual((await state(page)).q, q);
    // A target far away.
    for (const [x, name] of [["1000", "far"], ["1e300", "farther"]]) {
      await page.getByLabel("target x").fill(x);
      await page.keyboard.press("Enter");
      await page.waitForTimeout(400);
      const far = await state(page);
      assert.equal(far.status, "missed", name);
      assert.match(await page.locator("#why").innerText(), /out of reach|too far away/);
    }
    await page.screenshot({ path: join(shots, "far.png") });
    await page.locator("#sliders input[type=range]").nth(0).fill("5");
    assert.equal((await state(page)).status, "reached");
    // An arm without inverse: seven joints that name no redundant one.
    const row = "a: 0.1, alpha: 33, d: 0.2, theta: 0";
    await paste(page, yaml(Array(7).fill(row)));
    await until(page, () => window.denhart.app.facts?.name === "typed");
    assert.match(await page.locator("#no-inverse").innerText(), /no inverse kinematics/);
    assert.equal((await state(page)).seen.ghosts, 0);
    await page.locator("#sliders input[type=range]").nth(6).fill("40");
    near((await state(page)).q[6], (40 * Math.PI) / 180, 1e-9, "q7");
    // Ten joints, and eleven.
    await paste(page, yaml(Array(10).fill(row)));
    await until(page, () => window.denhart.app.facts?.joints.length === 10);
    assert.equal(await page.locator("#sliders .slider").count(), 10);
    await paste(page, yaml(Array(11).fill(row)));
    await told();
    await paste(page, good);
    await right("ur5");
    assert.deepEqual(page.failures, []);
  },

  async "every known arm opens"(browser) {
    const page = await open(browser);
    const names = await page.evaluate(async () => (await window.denhart.app.jobs.run({ kind: "presets" })).map((one) => one.name));
    assert.ok(names.length > 50);
    for (const name of names) {
      const found = await page.evaluate(async (name) => {
        const { app } = window.denhart;
        await app.setText(await app.jobs.run({ kind: "file", name }));
        const { width, height } = document.getElementById("view").getBoundingClientRect();
        const hidden = window.denhart.view.read().joints.filter(([x, y]) => !(x > 0 && x < width && y > 0 && y < height)).length;
        app.moveTo(app.q.map((value, joint) => value + 0.1 * Math.sin(joint + 1)));
        return { hidden, name: app.facts.name, task: app.facts.task, solutions: app.answer?.solutions.length, mistakes: app.messages.filter((one) => one.severity === "error").length };
      }, name);
      assert.equal(found.name, name);
      assert.equal(found.mistakes, 0, name);
      assert.equal(found.hidden, 0, `joints of ${name} outside the picture`);
      if (found.task) assert.ok(found.solutions > 0, `${name} reaches its own pose`);
    }
    assert.deepEqual(page.failures, []);
    await page.click("#presets");
    await page.fill("#gallery-search", "kuka");
    await page.waitForSelector(".card:not([hidden]) img");
    await page.waitForTimeout(1500);
    await page.screenshot({ path: join(shots, "gallery.png") });
  },

  async "undo comes back to every text, with mistakes or without"(browser) {
    const page = await open(browser);
    assert.equal(await page.locator("#undo").isDisabled(), true);
    assert.equal(await page.locator("#redo").isDisabled(), true);
    await choose(page, "puma560");
    const puma = (await state(page)).text;
    await page.locator("#editor .cm-content").click();
    await page.keyboard.press("Control+A");
    await page.keyboard.press("Delete");
    await until(page, () => window.denhart.app.messages.some((one) => one.severity === "error"));
    await page.click("#undo");
    const back = await state(page);
    assert.equal(back.name, "puma560");
    assert.equal(back.text, puma);
    assert.equal(await page.locator("#editor .cm-content").innerText().then((text) => text.includes("puma560")), true);
    await page.click("#undo");
    assert.equal((await state(page)).name, "ur5");
    assert.equal(await page.locator("#undo").isDisabled(), true);
    // Two arms, then a text that is none, typed so lately that nothing has looked at it.
    const one = (name) => yaml(["a: 0.4, alpha: 0, d: 0, theta: 0", "a: 0.3, alpha: 0, d: 0, theta: 0"]).replace("typed", name);
    for (const name of ["first", "second"]) {
      await paste(page, one(name));
      await until(page, (name) => window.denhart.app.facts?.name === name, name);
    }
    await paste(page, "garbage: [");
    await page.evaluate(() => window.denhart.app.undo());
    assert.equal((await state(page)).text, one("second"));
    assert.equal((await state(page)).name, "second");
    await page.click("#redo");
    assert.equal((await state(page)).text, "garbage: [");
    assert.equal(await page.locator("#redo").isDisabled(), true);
    // A file in its place, then back: the text and the arm that stood beside it.
    await drop(page, "ur5.yaml", readFileSync(join(root, "specs/ur5.yaml"), "utf8"));
    await until(page, () => window.denhart.app.facts?.name === "ur5");
    await page.click("#undo");
    assert.equal((await state(page)).text, "garbage: [");
    assert.equal((await state(page)).name, "second");
    await until(page, () => window.denhart.app.messages.some((one) => one.severity === "error"));
    assert.deepEqual(page.failures, []);
  },

  async "a reload shows what was there"(browser) {
    const page = await open(browser);
    await choose(page, "staubli_tx40");
    await page.locator("#sliders input[type=range]").nth(1).fill("33");
    const { q, text } = await state(page);
    const broken = text.replace("joints:", "jionts:");
    await paste(page, broken);
    await until(page, () => window.denhart.app.messages.some((one) => one.severity === "error"));
    await page.waitForTimeout(500);
    await page.reload();
    await page.waitForSelector("body.is-ready");
    const after = await state(page);
    assert.equal(after.text, broken);
    assert.equal(after.name, "staubli_tx40");
    after.q.forEach((value, joint) => near(value, q[joint], 1e-12, "joint"));
    assert.ok(after.messages.some((one) => one.severity === "error"));
    assert.deepEqual(page.failures, []);
  },

  async "a text with mistakes is not taken for the arm before"(browser) {
    const page = await open(browser);
    const { text } = await state(page);
    await paste(page, text.replace("name: ur5", "name: mine").replace("alpha: 90", "alfa: 90"));
    await until(page, () => document.body.classList.contains("has-mistakes"));
    assert.match(await page.locator("#stale").innerText(), /mistakes: this is still ur5/);
    const [saved] = await Promise.all([page.waitForEvent("download"), page.click("#save-arm")]);
    assert.equal(saved.suggestedFilename(), "mine.yaml");
    await page.click("#share");
    await page.waitForSelector(".notice:has-text('the last arm file without mistakes')");
    await page.setViewportSize({ width: 390, height: 800 });
    await page.waitForTimeout(300);
    await page.screenshot({ path: join(shots, "phone-stale.png") });
    await page.click("#stale");
    assert.equal(await page.locator("#table").isVisible(), true);
    await paste(page, text);
    await until(page, () => !document.body.classList.contains("has-mistakes"));
    assert.equal(await page.locator("#stale").evaluate((one) => one.hidden), true);
  },

  async "messages have the line to write"(browser) {
    const page = await open(browser);
    const { text } = await state(page);
    await paste(page, `${text}redundant: q3\n`);
    await until(page, () => window.denhart.app.messages.some((one) => one.severity === "error"));
    assert.match(await page.locator("#messages .message.error").innerText(), /write `inverse: \{redundant: q3\}`/);
    const seven = readFileSync(join(root, "specs/kuka_iiwa7_r800.yaml"), "utf8");
    await paste(page, seven.replace(/^inverse:.*\n/m, ""));
    await until(page, () => window.denhart.app.facts?.joints.length === 7);
    assert.match(await page.locator("#no-inverse").innerText(), / work;.*\. Write `inverse: \{task: pose, redundant: q1\}`$/);
    // Ten joints: this page has no code for them.
    await paste(page, yaml([267, 0, 293, 0, 342.5, 0, 97, 0, 50, 60].map((d, row) => `a: 0, alpha: ${row < 9 ? (row % 2 ? -90 : 90) : 0}, d: ${d / 1000}, theta: 0`)));
    await until(page, () => window.denhart.app.facts?.joints.length === 10);
    assert.match(await page.locator("#no-inverse").innerText(), /Write `inverse: .*this page has no inverse of so many joints/);
    // Angles cut early.
    await paste(page, text.replace("angle: deg", "angle: rad").replace(/alpha: -?90/g, "alpha: 1.57"));
    await until(page, () => window.denhart.app.messages.some((one) => one.message.includes("nearly pi/2")));
  },

  async "files that are no arms leave the text, and a URDF's chain can be cut"(browser) {
    const page = await open(browser);
    const { text } = await state(page);
    for (const [name, bad, told] of [["bin.dat", "\u0000\u0001PNG", /is no text/], ["table.csv", "1,2,3\n4,5,6\n", /without `joints`/], ["other.json", '{"a": [1, 2]}', /without `joints`/], ["page.svg", "<svg></svg>", /XML without/]]) {
      await drop(page, name, bad);
      await page.waitForSelector(`.notice:has-text('${name}')`);
      assert.match(await page.locator(`.notice:has-text('${name}')`).innerText(), told);
      assert.equal((await state(page)).text, text, name);
    }
    assert.ok((await page.locator(".notice").count()) <= 2);
    const joint = (name, type, parent, child) => `<joint name="${name}" type="${type}"><parent link="${parent}"/><child link="${child}"/><origin xyz="0.2 0 0.1"/><axis xyz="0 0 1"/></joint>`;
    const links = ["l0", "l1", "l2", "l3"].map((link) => `<link name="${link}"/>`).join("");
    await drop(page, "cut.urdf", `<robot name="cut">${links}${joint("j1", "continuous", "l0", "l1")}${joint("j2", "continuous", "l1", "l2")}${joint("j3", "floating", "l2", "l3")}</robot>`);
    await page.waitForSelector("#imported[open]");
    await page.locator("#ends button", { hasText: "up to l2" }).click();
    await until(page, () => window.denhart.app.facts?.joints.length === 2);
    assert.deepEqual(page.failures, []);
  },

  async "number fields step finely, and keep their value where no number is typed"(browser) {
    const page = await open(browser);
    const x = page.getByLabel("target x");
    const before = (await state(page)).target[9];
    await x.focus();
    await page.keyboard.press("ArrowUp");
    const moved = Math.abs((await state(page)).target[9] - before);
    assert.ok(moved > 1e-4 && moved < 0.03, `x moves by ${moved} m`);
    const field = page.locator("#sliders input[type=number]").first();
    const shown = await field.inputValue();
    const { q } = await state(page);
    for (const typed of ["", "-", "1e9"]) {
      await field.fill("");
      await field.pressSequentially(typed);
      await page.keyboard.press("Enter");
      await page.waitForSelector(".notice.mistake");
      assert.equal(await field.inputValue(), shown, `after "${typed}"`);
      assert.deepEqual((await state(page)).q, q);
    }
    // A slider that is moved by keys for a while is one step of undo.
    await page.locator("#sliders input[type=range]").first().focus();
    for (let step = 0; step < 5; step++) await page.keyboard.press("ArrowRight");
    near((await state(page)).q[0] - q[0], (5 * Math.PI) / 180, 1e-9, "five arrows");
    await page.keyboard.press("Control+Z");
    near((await state(page)).q[0], q[0], 1e-9, "one undo");
    // Letters work where a checkbox has the focus.
    await page.locator("#show-names").focus();
    await page.keyboard.press("d");
    assert.equal(await page.locator("#show-dimensions").isChecked(), true);
  },

  async "the page says how an arm stands"(browser) {
    const page = await open(browser);
    await choose(page, "puma560");
    await page.evaluate(() => window.denhart.app.moveTo([0.3, -0.5, 0.4, 0.2, 0, 0.1]));
    assert.match(await page.locator("#near").innerText(), /at a singularity: \w+/);
    await page.locator("#family input[type=range]").fill("50");
    assert.equal(await page.locator(".solution[aria-pressed=true]").count(), 1);
    assert.match(await page.locator(".solution[aria-pressed=true]").getAttribute("title"), /free: /);
    await page.locator("#family input[type=range]").blur();
    await page.evaluate(() => window.denhart.app.moveTo([0.3, -0.5, 0.4, 0.2, 0.9, 0.1]));
    assert.equal(await page.locator("#near").isVisible(), false);
    // The numbers of the solutions keep off the handles.
    await page.waitForTimeout(300);
    const onHandles = await page.evaluate(() => {
      const { app, view } = window.denhart;
      const [x, y] = view.project(app.target.slice(9, 12));
      const box = document.getElementById("view").getBoundingClientRect();
      return [...document.querySelectorAll("#labels .ghost:not([hidden])")].filter((one) => {
        const { left, right, top, bottom } = one.getBoundingClientRect();
        return Math.hypot((left + right) / 2 - box.x - x, (top + bottom) / 2 - box.y - y) < 45;
      }).length;
    });
    assert.equal(onHandles, 0);
    // Limits.
    await paste(page, yaml(["a: 0.4, alpha: 0, d: 0, theta: 0, limits: [-30, 30]", "a: 0.3, alpha: 0, d: 0, theta: 0, limits: [0, 170]"]));
    await until(page, () => window.denhart.app.facts?.name === "typed");
    await page.evaluate(() => window.denhart.app.moveTo([0.2, 0.7]));
    assert.equal(await page.locator("#solutions-title").innerText(), "2 solutions, 1 of 2 within limits");
    assert.equal(await page.locator("#sliders .has-low.has-high").count(), 2);
    await page.getByLabel("target x").fill("3");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => /workspace is [\d.]+ m away; the first equation .* distance of [\d.]+ m$/.test(document.getElementById("why").textContent));
    // The text of the numbers has no words of buttons.
    await page.click("#tab-pose");
    const [saved] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
    const text = readFileSync(await saved.path(), "utf8");
    assert.ok(text.includes("Jacobian") && text.includes("q2") && !/copy/.test(text), text);
  },

  async "the editor is as wide as it is made"(browser) {
    const page = await open(browser);
    const width = () => page.locator("#table").evaluate((one) => one.getBoundingClientRect().width);
    const before = await width();
    const bar = await page.locator("#splitter").boundingBox();
    await drag(page, [bar.x + 4, bar.y + 300], [120, 0]);
    near((await width()) - before, 120, 5, "dragged");
    await page.waitForTimeout(300);
    assert.ok(await page.evaluate(() => document.querySelector("#view canvas").getBoundingClientRect().width === document.querySelector("#view").getBoundingClientRect().width));
    await page.locator("#editor .cm-scroller").evaluate((one) => (one.scrollLeft = 200));
    await choose(page, "puma560");
    assert.equal(await page.locator("#editor .cm-scroller").evaluate((one) => one.scrollLeft), 0);
    // A key of the table says what it is.
    await page.getByText("convention", { exact: true }).first().hover();
    await page.waitForSelector(".key-words");
    await page.click("#tab-pose");
    assert.ok(await page.evaluate(() => [...document.querySelectorAll("#panel-pose .numbers")].every((one) => one.scrollWidth <= one.clientWidth)));
  },

  async "the keyboard alone is enough"(browser) {
    const page = await open(browser);
    const before = await state(page);
    await page.locator("#sliders input[type=range]").first().focus();
    await page.keyboard.press("Shift+ArrowRight");
    near((await state(page)).q[0] - before.q[0], (10 * Math.PI) / 180, 1e-9, "an arrow with Shift");
    await page.keyboard.press("3");
    const taken = await state(page);
    taken.q.forEach((value, joint) => near(value, taken.solutions[2].q[joint], 1e-9, "key 3"));
    await page.keyboard.press("Control+Z");
    near((await state(page)).q[0] - before.q[0], (10 * Math.PI) / 180, 1e-9, "undo");
    await page.keyboard.press("Control+Z");
    near((await state(page)).q[0], before.q[0], 1e-9, "undo twice");
    await page.keyboard.press("d");
    assert.ok(await page.locator("#labels .measure").count() > 0);
    await page.keyboard.press("p");
    await page.keyboard.type("scara");
    await page.waitForFunction(() => document.querySelectorAll(".card:not([hidden])").length === 1);
    await page.keyboard.press("Enter");
    await until(page, () => window.denhart.app.facts?.name.startsWith("scara"));
    // Every control has a name.
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll("button, input, [role=tab]")].filter((one) =>
        !one.hidden && !one.closest(".cm-editor") && !(one.getAttribute("aria-label") || one.textContent.trim() || one.closest("label"))).map((one) => one.outerHTML));
    assert.deepEqual(nameless, []);
  },

  async "a phone's width holds every part"(browser) {
    const page = await open(browser, { width: 390, height: 800 });
    for (const part of ["arm", "table", "results"]) {
      await page.click(`#go-${part}`);
      await page.waitForTimeout(400);
      await page.screenshot({ path: join(shots, `phone-${part}.png`) });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= 390, `${part} is ${wide} px wide`);
    }
    await page.click("#go-arm");
    await page.locator("#sliders input[type=range]").nth(0).fill("20");
    assert.equal((await state(page)).seen.ghosts, 8);
  },

  async "without WebGL there is the picture of denhart draw"() {
    const browser = await launch(["--disable-3d-apis"]);
    try {
      const page = await open(browser);
      await page.waitForSelector("#view .flat svg");
      const before = await page.locator("#view .flat svg").innerHTML();
      await page.locator("#sliders input[type=range]").nth(0).fill("70");
      await page.waitForTimeout(300);
      assert.notEqual(await page.locator("#view .flat svg").innerHTML(), before);
      await page.locator(".solution").nth(3).click();
      await page.screenshot({ path: join(shots, "flat.png") });
      await page.locator("#show-axes").check();
      await page.waitForFunction(() => document.querySelector("#view .flat svg").textContent.includes("axes 2, 3, 4 are parallel"));
      await page.screenshot({ path: join(shots, "flat-axes.png") });
    } finally {
      await browser.close();
    }
  },

  async "texts that nest too deep are refused at once, and the editor goes on"(browser) {
    const deep = `name: ${"[".repeat(99_000)}`;
    const page = await open(browser);
    const good = (await state(page)).text;
    for (const bad of [deep, `- ${"- ".repeat(30_000)}`, `{a: ${"{a: ".repeat(20_000)}`]) {
      const start = performance.now();
      await paste(page, bad);
      await until(page, () => window.denhart.app.messages.some((one) => /nests more than 64/.test(one.message)));
      assert.ok(performance.now() - start < 5000, `${Math.round(performance.now() - start)} ms for ${bad.slice(0, 12)}`);
      await paste(page, good);
      await until(page, () => window.denhart.app.messages.length === 0);
      // The language of the editor is back.
      await page.evaluate(() => window.denhart.app.mark(0));
      assert.equal(await page.locator("#editor .marked-row").count(), 1);
    }
    // Brackets of words are none: the text is that of an arm.
    await paste(page, `# ${"[".repeat(200)}\n${good.replace("name: ur5", `name: "${"{[".repeat(100)}"`)}`);
    await page.evaluate(() => window.denhart.app.settle());
    assert.ok((await state(page)).text.startsWith("# [["));
    assert.ok((await state(page)).messages.every((one) => !/nests/.test(one.message)));
    // A link that holds such a text, with an arm beside it.
    const fragment = await page.evaluate(async (text) => {
      const packed = new Blob([JSON.stringify({ text })]).stream().pipeThrough(new CompressionStream("deflate-raw"));
      const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
      return `#v1.${btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
    }, deep);
    const start = performance.now();
    const linked = await open(browser, { url: address + fragment });
    assert.ok(performance.now() - start < 10_000, "the page starts");
    assert.match((await state(linked)).messages[0].message, /nests more than 64/);
    await choose(linked, "puma560");
    assert.match(await linked.locator("#editor .cm-content").innerText(), /puma560/);
    await linked.waitForTimeout(500);
    await linked.reload();
    await linked.waitForSelector("body.is-ready");
    assert.equal((await state(linked)).name, "puma560");
    assert.deepEqual([...page.failures, ...linked.failures], []);
  },

  async "links that hold no arm say why"(browser) {
    for (const [bad, told] of [["#v1.", /damaged/], ["#v1.AAAA", /damaged/], ["#v1.%%%", /damaged/], ["#v2.abc", /another version/], ["#v1.q64FAA", /no arm file/]]) {
      const page = await open(browser, { url: address + bad });
      assert.match(await page.locator(".notice.mistake").innerText(), told, bad);
      await page.close();
    }
    // A target that is no pose.
    const page = await open(browser);
    await page.evaluate(() => window.denhart.app.aim([1, 1, 0, 0, 1, 0, 0, 0, 1, 0.3, 0.3, 0.3]));
    assert.equal(await page.locator("#solutions-title").innerText(), "No target");
    assert.match(await page.locator("#why").innerText(), /no pose/);
  },

  async "a number of the target changes no other"(browser) {
    const page = await open(browser);
    await page.evaluate(() => window.denhart.app.moveTo([0.123456789, -1.1, 1.2, 0.3, 0.7, 0.2]));
    const before = (await state(page)).target;
    await page.getByLabel("target x").fill("0.3");
    await page.keyboard.press("Enter");
    const moved = (await state(page)).target;
    assert.deepEqual(moved, before.with(9, 0.3));
    // The angles in degrees, from the target itself.
    const angles = (pose) => [Math.atan2(pose[7], pose[8]), Math.atan2(-pose[6], Math.hypot(pose[0], pose[3])), Math.atan2(pose[3], pose[0])];
    await page.getByLabel("target roll").fill("80");
    await page.keyboard.press("Enter");
    const turned = (await state(page)).target;
    assert.deepEqual(turned.slice(9), moved.slice(9));
    near(angles(turned)[0], (80 * Math.PI) / 180, 1e-12, "roll");
    for (const at of [1, 2]) near(angles(turned)[at], angles(moved)[at], 1e-12, ["", "pitch", "yaw"][at]);
    // A comma is told, and is no other number.
    await page.getByLabel("target x").fill("");
    await page.getByLabel("target x").pressSequentially("3,5");
    await page.waitForSelector(".notice:has-text('not a comma')");
    assert.notEqual(await page.getByLabel("target x").inputValue(), "3");
  },

  async "a field of the target with the focus shows the arm as it is"(browser) {
    const page = await open(browser);
    const x = page.getByLabel("target x");
    await x.focus();
    const shown = async () => near(Number(await x.inputValue()), (await state(page)).target[9], 1e-5, "x");
    await page.evaluate((text) => window.denhart.app.setText(text), readFileSync(join(root, "specs/puma560.yaml"), "utf8"));
    await shown();
    await page.evaluate(() => window.denhart.app.moveTo(window.denhart.app.q.map((value) => value + 0.1)));
    await shown();
    assert.ok(await x.evaluate((one) => one === document.activeElement));
    // What is typed stays while something else goes on.
    await x.fill("0.31");
    await page.evaluate(() => window.denhart.app.emit("posture"));
    assert.equal(await x.inputValue(), "0.31");
  },

  async "one limit makes a slider whose ends are in order"(browser) {
    const page = await open(browser);
    const row = (limits) => `a: 0.4, alpha: 0, d: 0, theta: 0, limits: ${limits}`;
    await paste(page, yaml([row("[200, null]"), row("[null, -200]"), row("[-10, null]")]));
    await until(page, () => window.denhart.app.facts?.name === "typed");
    const ends = await page.locator("#sliders input[type=range]").evaluateAll((all) => all.map((one) => [Number(one.min), Number(one.max)]));
    for (const [index, expected] of [[200, 560], [-560, -200], [-10, 350]].entries()) {
      expected.forEach((end, at) => near(ends[index][at], end, 1e-6, `end ${at} of slider ${index + 1}`));
    }
  },

  async "an import that ends late takes nothing's place, and no stale text is copied"(browser) {
    const page = await open(browser);
    const puma = readFileSync(join(root, "specs/puma560.yaml"), "utf8");
    // Both in one script: however busy the machine is, the import has not ended when the text is set.
    const waiting = await page.evaluate(async ([urdf, text]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([urdf], "late.urdf"));
      document.getElementById("view").dispatchEvent(new DragEvent("drop", { bubbles: true, cancelable: true, dataTransfer }));
      await window.denhart.app.setText(text);
      return [document.getElementById("copy").disabled, document.getElementById("save").disabled];
    }, [readFileSync(join(root, "cli/tests/urdf/kuka_kr6_r700.urdf"), "utf8"), puma]);
    assert.deepEqual(waiting, [true, true]);
    await page.waitForSelector(".notice:has-text('late.urdf is not taken')");
    assert.equal((await state(page)).name, "puma560");
    await page.waitForFunction(() => !document.getElementById("copy").disabled && document.querySelector("#panel-rust").innerText.includes("Puma560"));
    // A word in a comment makes no URDF of an arm file.
    await drop(page, "arm.yaml", `# made from <robot name="x">, without delta_theta\n${puma.replace("name: puma560", "name: mine")}`);
    await until(page, () => window.denhart.app.facts?.name === "mine");
  },

  async "a phone on its side holds every part"(browser) {
    for (const [width, height] of [[911, 512], [844, 390], [721, 480]]) {
      const page = await open(browser, { width, height });
      const over = await page.evaluate(() => {
        const last = [...document.querySelectorAll("#sliders input[type=range]")].at(-1);
        last.scrollIntoView({ block: "nearest" });
        const { left, top, width, height } = last.getBoundingClientRect();
        return document.elementFromPoint(left + width / 2, top + height / 2) === last ? "" : "covered";
      });
      assert.equal(over, "", `${width} by ${height}`);
      assert.equal(await page.locator("#results").isVisible(), false);
      assert.ok((await page.locator("#view").boundingBox()).height > 180);
      await page.screenshot({ path: join(shots, `phone-side-${width}.png`) });
      await page.click("#go-results");
      assert.equal(await page.locator("#results").isVisible(), true);
      await page.close();
    }
  },

  async "the joints have their own names, and a missed target its line"(browser) {
    const page = await open(browser);
    const rows = ["0, alpha: 90, d: 0.0892", "-0.425, alpha: 0, d: 0", "-0.39225, alpha: 0, d: 0", "0, alpha: 90, d: 0.10915", "0, alpha: -90, d: 0.09465", "0, alpha: 0, d: 0.0823"];
    await paste(page, yaml(["name: rail, type: prismatic, a: 0, alpha: 90, d: 0, theta: 0", ...rows.map((row) => `a: ${row}, theta: 0`)], "inverse: {task: pose, redundant: rail}\n"));
    await until(page, () => window.denhart.app.facts?.name === "typed");
    assert.equal(await page.locator("#given .name").innerText(), "rail");
    const browser2 = await launch(["--disable-3d-apis"]);
    try {
      const flat = await open(browser2);
      await flat.waitForSelector("#view .flat svg");
      await flat.getByLabel("target x").fill("3");
      await flat.keyboard.press("Enter");
      await flat.waitForFunction(() => / short/.test(document.querySelector("#view .flat svg").textContent));
    } finally {
      await browser2.close();
    }
  },

  async "a served page keeps its token, its file and what is typed"(browser) {
    const text = readFileSync(join(root, "specs/ur5.yaml"), "utf8");
    const [file, server, url] = await serve(text);
    const disk = () => readFileSync(file, "utf8");
    try {
      const context = await browser.newContext({ permissions: ["clipboard-read", "clipboard-write"] });
      const page = await open(context, { url });
      const end = async (words) => {
        await page.locator("#editor .cm-content").click();
        await page.keyboard.press("Control+End");
        await page.keyboard.insertText(words);
      };
      const told = (words) => page.waitForSelector(`.notice:has-text('${words}')`);
      const quiet = () => page.evaluate(() => document.getElementById("notices").replaceChildren());
      const typed = () => page.evaluate(() => window.denhart.app.text);
      // The link has no token, and the address stays.
      await page.click("#share");
      await told("end of a link copied");
      assert.match(await page.evaluate(() => navigator.clipboard.readText()), /^#v1\.[\w-]+$/);
      assert.equal(page.url(), url);
      // A file that has changed since is not overwritten: the write is refused, and the page asks.
      await page.route("**/arm?*", (route) => (route.request().method() === "GET" ? route.abort() : route.continue()));
      await told("the command has ended, or cannot be reached");
      await end("# mine\n");
      writeFileSync(file, `${text}# theirs\n`);
      await page.evaluate(() => document.getElementById("write").click());
      await told("is not written: the file has changed");
      assert.equal(disk(), `${text}# theirs\n`);
      await page.unroute("**/arm?*");
      await page.waitForSelector("#changed:not([hidden])");
      assert.match(await typed(), /# mine\n$/);
      await page.screenshot({ path: join(shots, "changed.png") });
      // What is typed stays, and is written now; at once, before the editor has handed it on.
      await page.click("#keep-mine");
      await end("# fast\n");
      await page.evaluate(() => document.getElementById("write").click());
      await told("arm.yaml written");
      assert.equal(disk(), `${text}# mine\n# fast\n`);
      assert.equal(await page.locator("#changed").isVisible(), false);
      // Or the file's text comes, and undo brings back what was typed.
      await end("# more\n");
      writeFileSync(file, `${text}# theirs again\n`);
      await page.click("#take-file");
      await until(page, () => window.denhart.app.text.endsWith("# theirs again\n"));
      await page.click("#undo");
      assert.match(await typed(), /# more\n$/);
      await page.click("#redo");
      // Unsaved edits outlive a reload after a write.
      await end("# once\n");
      await quiet();
      await page.click("#write");
      await told("arm.yaml written");
      await end("# unsaved\n");
      await page.waitForTimeout(600);
      const again = async (to) => {
        await (to ? page.goto(to) : page.reload());
        await page.waitForSelector("body.is-ready");
      };
      await again();
      assert.match(await typed(), /# once\n# unsaved\n$/);
      assert.match(disk(), /# once\n$/);
      // A file that changed meanwhile comes first, and undo comes back to them.
      await page.goto("about:blank");
      writeFileSync(file, text.replace("name: ur5", "name: newer"));
      await page.goBack();
      await until(page, () => window.denhart?.app.facts?.name === "newer");
      await page.waitForSelector("body.is-ready");
      await page.click("#undo");
      assert.match(await typed(), /# unsaved\n$/);
      await page.click("#redo");
      // The file comes before a fragment.
      const fragment = await page.evaluate(() => navigator.clipboard.readText());
      await page.goto("about:blank");
      await again(url + fragment);
      await told("the arm of the link is left out");
      assert.equal((await state(page)).name, "newer");
      assert.equal(page.url(), url);
      // Line ends stay those of the file.
      writeFileSync(file, text.replaceAll("\n", "\r\n"));
      await until(page, () => window.denhart.app.facts?.name === "ur5");
      await end("# end\n");
      await quiet();
      await page.click("#write");
      await told("arm.yaml written");
      assert.equal(disk(), `${text}# end\n`.replaceAll("\n", "\r\n"));
      // A command that has ended is told.
      server.kill();
      await told("cannot be read: the command has ended, or cannot be reached");
      await page.click("#write");
      await told("is not written: the command has ended, or cannot be reached");
      await context.close();
    } finally {
      server.kill();
    }
  },

  async "denhart view serves, follows and writes"(browser) {
    const text = readFileSync(join(root, "specs/ur5.yaml"), "utf8");
    const [file, server, url] = await serve(text);
    try {
      const page = await open(browser, { url });
      assert.equal((await state(page)).name, "ur5");
      writeFileSync(file, text.replace("name: ur5", "name: changed"));
      await until(page, () => window.denhart.app.facts?.name === "changed");
      await paste(page, text.replace("name: ur5", "name: written"));
      await until(page, () => window.denhart.app.facts?.name === "written");
      await page.click("#write");
      await page.waitForSelector(".notice:has-text('written')");
      assert.match(readFileSync(file, "utf8"), /name: written/);
      const { host } = new URL(url);
      assert.deepEqual(page.requests.filter((one) => !/^(data|blob):/.test(one) && new URL(one).host !== host), []);
      const status = (path, headers) => new Promise((done) => {
        const [name, port] = host.split(":");
        request({ host: name, port, path, headers }, (reply) => { reply.resume(); done(reply.statusCode); }).end();
      });
      const own = new URL(url).search;
      assert.equal(await status(`/${own}`, {}), 200);
      assert.equal(await status("/", {}), 403);
      assert.equal(await status(`/${own}`, { host: "evil.example" }), 403);
      assert.equal(await status(`/arm${own}`, { origin: "http://evil.example" }), 403);
      assert.equal(await status(`/../../etc/passwd${own}`, {}), 404);
      // One file that works by itself.
      const out = join(dirname(file), "page.html");
      denhart("view", file, "--export", out);
      const exported = await open(browser, { url: pathToFileURL(out).href });
      assert.equal((await state(exported)).name, "written");
      assert.deepEqual(exported.requests.filter((one) => !/^(file|data|blob):/.test(one)), []);
    } finally {
      server.kill();
    }
  },
};

function median(values) {
  return values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)] ?? NaN;
}

const only = process.env.ONLY;
const browser = await launch(WITH_3D);
let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  if (only && !name.includes(only)) continue;
  const start = performance.now();
  try {
    await test(browser);
    console.log(`ok   ${name} (${((performance.now() - start) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed++;
    console.log(`FAIL ${name}: ${error.stack}`);
  }
  for (const context of browser.contexts()) await context.close();
}
await browser.close();
process.exit(failed ? 1 : 0);
