// The target in space: a frame to drag and to turn.

import * as THREE from "three";
import { TransformControls } from "three/addons/controls/TransformControls.js";
import type { App } from "./app";
import type { Pose } from "./numbers";

const matrix = new THREE.Matrix4();
const axes = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()] as const;

/** The pose of an object in space. */
function poseOf(object: THREE.Object3D): Pose {
  matrix.makeRotationFromQuaternion(object.quaternion.normalize()).extractBasis(...axes);
  const [x, y, z] = axes;
  return [x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z, ...object.position.toArray()];
}

/** Puts an object into a pose. */
export function setPose(object: THREE.Object3D, pose: Pose): void {
  const [a = 1, b = 0, c = 0, d = 0, e = 1, f = 0, g = 0, h = 0, i = 1, x = 0, y = 0, z = 0] = pose;
  matrix.set(a, b, c, 0, d, e, f, 0, g, h, i, 0, 0, 0, 0, 1);
  object.quaternion.setFromRotationMatrix(matrix);
  object.position.set(x, y, z);
}

export class Aim3D {
  readonly target = new THREE.Object3D();
  readonly controls: TransformControls;
  isDragging = false;

  constructor(
    private readonly app: App,
    private readonly scene: THREE.Scene,
    camera: THREE.Camera,
    dom: HTMLElement,
    onDrag: (dragging: boolean) => void,
  ) {
    this.controls = new TransformControls(camera, dom);
    this.controls.setSize(0.75);
    scene.add(this.target, this.controls.getHelper());
    this.controls.addEventListener("dragging-changed", (event) => {
      this.isDragging = event.value === true;
      onDrag(this.isDragging);
      if (!this.isDragging) app.remember();
    });
    this.controls.addEventListener("objectChange", () => app.timed(() => app.aim(poseOf(this.target))));
  }

  /** Handles as the task of the arm has use for. */
  fit(mode: "translate" | "rotate"): void {
    const task = this.app.facts?.task;
    const helper = this.controls.getHelper();
    if (!task) {
      this.controls.detach();
      helper.visible = false;
      return;
    }
    this.controls.attach(this.target);
    helper.visible = true;
    const isFlat = task.startsWith("planar");
    const turns = task === "pose" || task === "position_axis" || task === "planar_pose";
    this.controls.setMode(mode === "rotate" && turns ? "rotate" : "translate");
    const rotates = this.controls.mode === "rotate";
    this.controls.setSpace(rotates ? "local" : "world");
    this.controls.showX = this.controls.showY = !(rotates && isFlat);
    this.controls.showZ = rotates || !isFlat;
  }

  /** The target follows the page. */
  follow(): void {
    if (!this.isDragging && this.app.target.length === 12) setPose(this.target, this.app.target);
  }

  get object(): THREE.Scene {
    return this.scene;
  }
}
