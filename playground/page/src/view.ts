// The arm in space: the picture in the middle of the page.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Aim3D } from "./aim3d";
import { Annotations } from "./annotations";
import type { App, Change } from "./app";
import { Axes3D } from "./axes3d";
import { color, css, inkOn, onThemeChange, solutionColor } from "./colors";
import { notice } from "./dom";
import { Figure3D } from "./figure3d";
import { Labels, type Label } from "./labels";
import { bits, OUT_OF_LIMITS, short, type Figure, type Point } from "./numbers";
import { NEAR_SINGULAR } from "./remarks";

export class View {
  readonly scene = new THREE.Scene();
  readonly camera = new THREE.PerspectiveCamera(32, 1, 0.01, 100);
  readonly ghosts: Figure3D[] = [];
  arm: Figure3D | undefined;
  mode: "translate" | "rotate" = "translate";
  private readonly renderer: THREE.WebGLRenderer;
  private readonly orbit: OrbitControls;
  private readonly aim: Aim3D;
  private readonly annotations: Annotations;
  private readonly axes: Axes3D;
  private readonly labels: Labels;
  private readonly ray = new THREE.Raycaster();
  private readonly ground = new THREE.Group();
  private size = 1;
  private dirty = true;
  /** The user has chosen this view: it stays. */
  private isChosen = false;

  constructor(private readonly app: App, private readonly box: HTMLElement, overlay: HTMLElement) {
    this.renderer = new THREE.WebGLRenderer({ antialias: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute("aria-label", "The arm. Arrow keys turn the view, + and - come nearer and go farther.");
    box.prepend(canvas);
    this.camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.addEventListener("change", () => this.draw());
    this.orbit.addEventListener("start", () => (this.isChosen = true));
    this.aim = new Aim3D(app, this.scene, this.camera, canvas, (dragging) => (this.orbit.enabled = !dragging));
    this.aim.controls.addEventListener("change", () => this.draw());
    this.labels = new Labels(overlay);
    this.annotations = new Annotations(this.scene);
    this.axes = new Axes3D(this.scene);
    this.scene.add(this.ground, new THREE.HemisphereLight(0xffffff, 0x8a94a0, 2.1));
    const sun = new THREE.DirectionalLight(0xffffff, 1.6);
    sun.position.set(2, -3, 5);
    this.scene.add(sun);
    this.listenToPointer(canvas);
    canvas.addEventListener("keydown", (event) => this.key(event));
    canvas.addEventListener("webglcontextlost", () => notice("The browser has taken the picture's memory: it comes back when there is some again.", true));
    canvas.addEventListener("webglcontextrestored", () => this.draw());
    new ResizeObserver(() => this.resize()).observe(box);
    onThemeChange(() => this.restyle());
    app.listen((change) => this.change(change));
    this.resize();
    this.restyle();
    const loop = (): void => {
      requestAnimationFrame(loop);
      if (this.dirty && !document.hidden) this.render();
    };
    loop();
  }

  /** Handles that move the target, or that turn it. */
  setMode(mode: "translate" | "rotate"): void {
    this.mode = mode;
    this.aim.fit(mode);
    this.draw();
  }

  private change(change: Change): void {
    if (change === "arm") {
      this.arm?.dispose();
      for (const ghost of this.ghosts.splice(0)) ghost.dispose();
      this.arm = undefined;
    }
    if (change === "kept") this.bringBack();
    if (change === "text" || change === "messages" || change === "kept" || change === "file") return;
    this.update();
    if (change === "framed") this.frame();
  }

  /** A posture that has left the picture is brought back. */
  private bringBack(): void {
    const { width, height } = this.box.getBoundingClientRect();
    const isOut = ([x, y]: [number, number]): boolean => x < 0 || y < 0 || x > width || y > height;
    if (!this.isChosen && this.arm && this.read().joints.some(isOut)) this.frame();
  }

  /** Radius of a link. */
  private get unit(): number {
    return this.size * 0.017;
  }

  private update(): void {
    const { app } = this;
    const { figure, facts } = app;
    if (!figure || !facts) return;
    if (!this.arm) {
      this.size = sizeOf(figure);
      this.arm = new Figure3D(facts.joints, { link: 0, joint: 0, opacity: 1, scale: 1, axes: true });
      this.scene.add(this.arm.group);
      this.aim.fit(this.mode);
      this.drawGround();
    }
    const outside = new Set(bits(figure.outside, facts.joints.length));
    const marked = app.marked === undefined ? undefined : facts.rows[app.marked];
    const link = linkColor(figure.margin);
    this.arm.pose(
      figure,
      this.unit,
      link,
      (joint) => (outside.has(joint) ? color("limit") : marked?.joint === joint ? color("marked") : color("joint")),
      (at) => (marked && app.marked !== undefined && at === linkOfRow(facts.rows, app.marked) ? color("marked") : 0),
    );
    this.updateGhosts();
    this.aim.follow();
    this.annotate();
    this.draw();
  }

  private updateGhosts(): void {
    const { app } = this;
    const { facts } = app;
    const solutions = app.shown.ghosts ? (app.answer?.solutions ?? []) : [];
    solutions.forEach((solution, index) => {
      const ghost = (this.ghosts[index] ??= this.makeGhost(index));
      ghost.group.visible = true;
      const isPointed = app.pointed === index;
      const outside = (solution.flags & OUT_OF_LIMITS) !== 0;
      ghost.restyle({ link: 0, joint: 0, opacity: isPointed ? 0.9 : outside ? 0.22 : 0.45, scale: isPointed ? 0.9 : 0.7, axes: false });
      const of = solutionColor(index);
      const limits = new Set(bits(solution.figure.outside, facts?.joints.length ?? 0));
      ghost.pose(solution.figure, this.unit, of, (joint) => (limits.has(joint) ? color("limit") : of), () => 0);
    });
    for (const ghost of this.ghosts.slice(solutions.length)) ghost.group.visible = false;
  }

  private makeGhost(index: number): Figure3D {
    const ghost = new Figure3D(this.app.facts?.joints ?? [], { link: 0, joint: 0, opacity: 0.45, scale: 0.7, axes: false });
    ghost.group.userData.ghost = index;
    this.scene.add(ghost.group);
    return ghost;
  }

  /** Frames, lengths, axes, names, and the reason of "no solution". */
  private annotate(): void {
    const { app } = this;
    const { arm, figure, facts } = app;
    if (!arm || !figure || !facts) return;
    const labels: Label[] = [];
    if (app.miss) {
      const words = missWords(app);
      labels.push({ point: pointOfTool(figure), text: words, kind: "miss", color: css(color("target")) });
    }
    const marked = app.marked === undefined ? undefined : app.marked + 1;
    const wants = app.shown.frames || app.shown.dimensions || app.shown.axes || marked !== undefined;
    const table = wants ? (JSON.parse(arm.table(Float64Array.from(app.q))) as import("./facts").TableParts) : undefined;
    labels.push(...this.annotations.show(table, { ...app.shown, marked, size: this.size, unit: facts.unit }));
    const axes = this.axes.show((app.shown.axes && table?.axes) || [], this.unit);
    // No axis of the arm decides: the picture says so.
    if (app.shown.axes && axes.length === 0) axes.push({ point: [0, 0, 0], text: facts.axes, kind: "axes", color: css(color("deciding")) });
    labels.push(...axes);
    this.annotations.missed(app.miss ? [pointOfTool(figure), pointOfTool({ tool: app.target })] : undefined);
    if (app.shown.names) {
      figure.joints.forEach(({ point }, joint) => {
        labels.push({ point, text: facts.joints[joint]?.name ?? "", kind: "joint" });
      });
    }
    if (app.shown.ghosts) {
      (app.answer?.solutions ?? []).forEach((solution, index) => {
        const name = app.branches[index] ?? "";
        labels.push({
          point: elbow(solution.figure),
          others: [1, 2, -1].map((before) => elbow(solution.figure, before)),
          text: app.pointed === index && name !== "-" ? `${index + 1} ${name}` : String(index + 1),
          kind: "ghost",
          color: css(solutionColor(index)),
          ink: inkOn(solutionColor(index)),
          title: name,
          isStrong: app.pointed === index,
          click: () => app.choose(index),
        });
      });
    }
    for (const [axis, name] of ["x", "y", "z"].entries()) {
      const point = [0, 1, 2].map((at) => (at === axis ? 0.24 * this.size : 0)) as Point;
      labels.push({ point, text: name, kind: "frame" });
    }
    this.labels.target = facts.task ? pointOfTool({ tool: app.target }) : undefined;
    this.labels.set(labels);
  }

  /** The camera looks at the whole arm. */
  frame(): void {
    this.isChosen = false;
    const { figure, answer, facts } = this.app;
    if (!figure) return;
    const reach = this.size;
    // The arm and its solutions.
    const figures = [figure, ...(answer?.solutions ?? []).map((solution) => solution.figure)];
    const around = new THREE.Box3();
    for (const point of figures.flatMap((one) => one.links.flat())) around.expandByPoint(new THREE.Vector3(...point));
    const { center, radius } = around.getBoundingSphere(new THREE.Sphere());
    const half = Math.min(this.camera.fov / 2, Math.atan(Math.tan((this.camera.fov * Math.PI) / 360) * this.camera.aspect) * (180 / Math.PI));
    const away = (1.25 * Math.max(radius, 0.3 * reach)) / Math.sin((half * Math.PI) / 180);
    const direction = facts?.planar ? new THREE.Vector3(0, -0.02, 1) : new THREE.Vector3(0.85, -1.35, 0.75);
    this.camera.position.copy(center).addScaledVector(direction.normalize(), away);
    this.camera.near = reach * 0.02;
    this.camera.far = reach * 60;
    this.camera.updateProjectionMatrix();
    this.orbit.target.copy(center);
    this.orbit.update();
    this.draw();
  }

  /** Projected joint positions, axes that decide the inverse, ghosts and colors: for tests. */
  read(): {
    joints: [number, number][]; axes: [number, number][][]; meet: [number, number][];
    ghosts: number; ghostColors: string[]; jointColors: string[];
  } {
    this.camera.updateMatrixWorld();
    const joints = (this.app.figure?.joints ?? []).map(({ point }) => this.project(point));
    const { lines, points } = this.axes.read();
    const shown = this.ghosts.filter((ghost) => ghost.group.visible);
    return {
      joints,
      axes: lines.map((ends) => ends.map((end) => this.project(end))),
      meet: points.map((point) => this.project(point)),
      ghosts: shown.length,
      ghostColors: shown.map((ghost) => css(ghost.jointColors()[0] ?? 0)),
      jointColors: (this.arm?.jointColors() ?? []).map(css),
    };
  }

  /** A point of space on the screen, px from the corner of the picture. */
  project(point: Point): [number, number] {
    const { width, height } = this.box.getBoundingClientRect();
    const at = new THREE.Vector3(...point).project(this.camera);
    return [((at.x + 1) / 2) * width, ((1 - at.y) / 2) * height];
  }

  draw(): void {
    this.dirty = true;
  }

  private render(): void {
    this.dirty = false;
    this.renderer.render(this.scene, this.camera);
    const { clientWidth, clientHeight } = this.box;
    this.labels.place(this.camera, clientWidth, clientHeight);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.box;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  private restyle(): void {
    this.scene.background = new THREE.Color(color("background"));
    this.drawGround();
    this.update();
  }

  private drawGround(): void {
    this.ground.clear();
    const cells = 10;
    const cell = niceStep(this.size / 4);
    const grid = new THREE.GridHelper(cells * cell, cells, color("grid"), color("grid"));
    grid.rotation.x = Math.PI / 2;
    const axes: [Point, number][] = [[[1, 0, 0], color("x")], [[0, 1, 0], color("y")], [[0, 0, 1], color("z")]];
    const origin = new THREE.Vector3();
    const arrows = axes.map(([axis, of]) =>
      new THREE.ArrowHelper(new THREE.Vector3(...axis), origin, this.size * 0.22, of, this.size * 0.05, this.size * 0.03));
    this.ground.add(grid, ...arrows);
  }

  private listenToPointer(canvas: HTMLElement): void {
    let [downX, downY] = [0, 0];
    canvas.addEventListener("pointerdown", (event) => ([downX, downY] = [event.clientX, event.clientY]));
    canvas.addEventListener("pointermove", (event) => {
      if (event.buttons === 0) this.app.point(this.hit(event));
    });
    canvas.addEventListener("pointerleave", () => this.app.point(undefined));
    canvas.addEventListener("pointerup", (event) => {
      if (Math.hypot(event.clientX - downX, event.clientY - downY) > 4 || this.aim.isDragging) return;
      const index = this.hit(event);
      if (index !== undefined) this.app.choose(index);
    });
  }

  /** The ghost under the pointer. The arm itself and the handles of the target come first. */
  private hit(event: PointerEvent): number | undefined {
    if (this.aim.controls.axis) return undefined;
    const box = this.box.getBoundingClientRect();
    const at = new THREE.Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    this.ray.setFromCamera(at, this.camera);
    const shown = this.ghosts.filter((ghost) => ghost.group.visible);
    const [first] = this.ray.intersectObjects([...shown, ...(this.arm ? [this.arm] : [])].flatMap((figure) => figure.meshes()), false);
    return first?.object.parent?.userData.ghost as number | undefined;
  }

  private key(event: KeyboardEvent): void {
    const offset = this.camera.position.clone().sub(this.orbit.target);
    const spherical = { turn: 0, lift: 0, near: 1 };
    if (event.key === "ArrowLeft") spherical.turn = -0.08;
    else if (event.key === "ArrowRight") spherical.turn = 0.08;
    else if (event.key === "ArrowUp") spherical.lift = 0.08;
    else if (event.key === "ArrowDown") spherical.lift = -0.08;
    else if (event.key === "+" || event.key === "=") spherical.near = 0.9;
    else if (event.key === "-") spherical.near = 1.1;
    else return;
    event.preventDefault();
    this.isChosen = true;
    const side = new THREE.Vector3(0, 0, 1).cross(offset).normalize();
    offset.applyAxisAngle(new THREE.Vector3(0, 0, 1), spherical.turn).applyAxisAngle(side, -spherical.lift);
    this.camera.position.copy(this.orbit.target).addScaledVector(offset, spherical.near);
    this.orbit.update();
    this.draw();
  }
}

const pointOfTool = ({ tool }: { tool: number[] }): Point => [tool[9] ?? 0, tool[10] ?? 0, tool[11] ?? 0];

/** The joint in the middle of an arm, at which its solutions are apart; or one so many joints before it. */
function elbow(figure: Figure, before = 0): Point {
  const joints = figure.joints;
  return joints[Math.min(Math.max(Math.floor(joints.length / 2) - before, 0), joints.length - 1)]?.point ?? [0, 0, 0];
}

/** The largest distance of a corner from the base. */
function sizeOf(figure: Figure): number {
  return Math.max(...figure.links.flat().map((point) => Math.hypot(...point))) || 1;
}

/** 1, 2 or 5 times a power of ten. */
function niceStep(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  return ([1, 2, 5].find((step) => step * power >= length * 0.7) ?? 10) * power;
}

/** The color of the links: orange at a singularity, gray away from all. */
export function linkColor(margin: number): number {
  const away = Number.isNaN(margin) ? 1 : Math.min(margin / NEAR_SINGULAR, 1);
  return new THREE.Color(color("singular")).lerp(new THREE.Color(color("link")), away).getHex();
}

/** The link that a row leads along: that after its joint, or after the joint before a fixed row. */
function linkOfRow(rows: { joint: number | null }[], row: number): number {
  const before = rows.slice(0, row + 1).filter((one) => one.joint !== null);
  return before.length;
}

/** The reason of "no solution", with what is missed. */
export function missWords(app: App): string {
  const { miss, facts } = app;
  if (!miss) return "";
  if (miss.distance !== null) return `out of reach: the workspace is ${short(miss.distance)} ${facts?.unit ?? ""} away`;
  if (miss.direction !== null) return `this direction is missed by ${short((miss.direction * 180) / Math.PI, 2)}°`;
  return "";
}
