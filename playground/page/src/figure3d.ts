// An arm in space: joints as cylinders and boxes, links as rods, an arrow on each axis.

import * as THREE from "three";
import type { JointFacts } from "./facts";
import type { Figure, Point } from "./numbers";

/** Rods of one arm at most. */
const MOST_RODS = 160;

const rod = new THREE.CylinderGeometry(1, 1, 1, 14).rotateX(Math.PI / 2);
const ball = new THREE.SphereGeometry(1, 14, 10);
const drum = new THREE.CylinderGeometry(1, 1, 1, 26).rotateX(Math.PI / 2);
const box = new THREE.BoxGeometry(1, 1, 1);
const tip = new THREE.ConeGeometry(1, 1, 16).rotateX(Math.PI / 2);

const Z = new THREE.Vector3(0, 0, 1);
const from = new THREE.Vector3();
const to = new THREE.Vector3();
const direction = new THREE.Vector3();
const turn = new THREE.Quaternion();
const size = new THREE.Vector3();
const place = new THREE.Matrix4();
const shade = new THREE.Color();

export interface Look {
  link: number;
  joint: number;
  /** 1 is solid. */
  opacity: number;
  /** Thickness, beside that of the arm itself. */
  scale: number;
  axes: boolean;
}

export class Figure3D {
  readonly group = new THREE.Group();
  private readonly rods: THREE.InstancedMesh;
  private readonly balls: THREE.InstancedMesh;
  private readonly drums: THREE.InstancedMesh;
  private readonly boxes: THREE.InstancedMesh;
  private readonly tips: THREE.InstancedMesh;
  private readonly material: THREE.MeshLambertMaterial;

  constructor(private readonly joints: JointFacts[], private look: Look) {
    this.material = new THREE.MeshLambertMaterial();
    const make = (geometry: THREE.BufferGeometry, count: number): THREE.InstancedMesh => {
      const mesh = new THREE.InstancedMesh(geometry, this.material, Math.max(count, 1));
      mesh.frustumCulled = false;
      mesh.setColorAt(0, shade.set(0));
      this.group.add(mesh);
      return mesh;
    };
    const turning = joints.filter((joint) => joint.turns).length;
    this.rods = make(rod, MOST_RODS);
    this.balls = make(ball, MOST_RODS);
    this.drums = make(drum, turning);
    this.boxes = make(box, joints.length - turning);
    this.tips = make(tip, joints.length * 2);
    this.restyle(look);
  }

  restyle(look: Look): void {
    this.look = look;
    this.material.transparent = look.opacity < 1;
    this.material.opacity = look.opacity;
    this.material.depthWrite = look.opacity >= 0.5;
    this.group.renderOrder = look.opacity < 1 ? 1 : 0;
  }

  /** Puts the arm into a posture. `unit`: radius of its links. `jointColor` overrides the color of a joint. */
  pose(figure: Figure, unit: number, linkColor: number, jointColor: (joint: number) => number, linkOf: (link: number) => number): void {
    const radius = unit * this.look.scale;
    let count = 0;
    figure.links.forEach((corners, link) => {
      const color = linkOf(link) || linkColor;
      for (let at = 1; at < corners.length; at++) {
        if (count < MOST_RODS && this.between(this.rods, count, corners[at - 1]!, corners[at]!, radius)) {
          this.rods.setColorAt(count, shade.set(color));
          place.makeScale(radius, radius, radius).setPosition(...corners[at]!);
          this.balls.setMatrixAt(count, place);
          this.balls.setColorAt(count, shade.set(color));
          count++;
        }
      }
    });
    this.rods.count = count;
    this.balls.count = count;
    let [drums, boxes, tips] = [0, 0, 0];
    figure.joints.forEach(({ point, axis }, joint) => {
      direction.set(...axis).normalize();
      turn.setFromUnitVectors(Z, direction);
      from.set(...point);
      const color = shade.set(jointColor(joint));
      if (this.joints[joint]?.turns) {
        this.drums.setMatrixAt(drums, place.compose(from, turn, size.set(2 * radius, 2 * radius, 4.6 * radius)));
        this.drums.setColorAt(drums++, color);
      } else {
        this.boxes.setMatrixAt(boxes, place.compose(from, turn, size.set(3.4 * radius, 3.4 * radius, 5.4 * radius)));
        this.boxes.setColorAt(boxes++, color);
      }
      if (this.look.axes) {
        to.copy(from).addScaledVector(direction, 5.4 * radius);
        this.tips.setMatrixAt(tips, place.compose(to, turn, size.set(0.28 * radius, 0.28 * radius, 8 * radius)));
        this.tips.setColorAt(tips++, color);
        to.copy(from).addScaledVector(direction, 6.6 * radius);
        this.tips.setMatrixAt(tips, place.compose(to, turn, size.set(0.9 * radius, 0.9 * radius, 2.4 * radius)));
        this.tips.setColorAt(tips++, color);
      }
    });
    this.drums.count = drums;
    this.boxes.count = boxes;
    this.tips.count = tips;
    for (const mesh of this.meshes()) {
      mesh.instanceMatrix.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
      mesh.boundingSphere = null;
    }
  }

  meshes(): THREE.InstancedMesh[] {
    return [this.rods, this.balls, this.drums, this.boxes, this.tips];
  }

  /** Colors of the joints, as they are drawn. */
  jointColors(): number[] {
    let [drums, boxes] = [0, 0];
    return this.joints.map((joint) => {
      if (joint.turns) this.drums.getColorAt(drums++, shade);
      else this.boxes.getColorAt(boxes++, shade);
      return shade.getHex();
    });
  }

  dispose(): void {
    this.group.removeFromParent();
    for (const mesh of this.meshes()) mesh.dispose();
    this.material.dispose();
  }

  /** A rod between two points. False where they are one. */
  private between(mesh: THREE.InstancedMesh, index: number, start: Point, end: Point, radius: number): boolean {
    from.set(...start);
    to.set(...end);
    direction.subVectors(to, from);
    const length = direction.length();
    if (length < radius * 1e-3) return false;
    turn.setFromUnitVectors(Z, direction.divideScalar(length));
    from.add(to).multiplyScalar(0.5);
    mesh.setMatrixAt(index, place.compose(from, turn, size.set(radius, radius, length)));
    return true;
  }
}
