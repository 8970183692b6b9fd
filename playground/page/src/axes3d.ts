// The axes that decide the inverse: thin rods along them, a ball where they meet.

import * as THREE from "three";
import { color, css } from "./colors";
import type { DecidingAxes } from "./facts";
import type { Label } from "./labels";
import type { Point } from "./numbers";

/** Three axes of a closed form, or two pairs where a joint is held. */
const MOST = 4;

const rod = new THREE.CylinderGeometry(1, 1, 1, 8).rotateX(Math.PI / 2);
const ball = new THREE.SphereGeometry(1, 18, 12);
const Z = new THREE.Vector3(0, 0, 1);

export class Axes3D {
  private readonly material = new THREE.MeshBasicMaterial({ depthTest: false, transparent: true, opacity: 0.85 });
  private readonly rods = new THREE.InstancedMesh(rod, this.material, MOST);
  private readonly balls = new THREE.InstancedMesh(ball, this.material, MOST);

  constructor(scene: THREE.Scene) {
    for (const mesh of [this.rods, this.balls]) {
      mesh.count = 0;
      mesh.frustumCulled = false;
      mesh.renderOrder = 2;
      scene.add(mesh);
    }
  }

  /** Draws the axes, and returns their relations in words. `unit`: radius of a link. */
  show(axes: DecidingAxes[], unit: number): Label[] {
    this.material.color.set(color("deciding"));
    const place = new THREE.Matrix4();
    const turn = new THREE.Quaternion();
    const lines = axes.flatMap((one) => one.lines).slice(0, MOST);
    lines.forEach((ends, index) => {
      const [from, to] = ends.map((end) => new THREE.Vector3(...end)) as [THREE.Vector3, THREE.Vector3];
      const along = to.clone().sub(from);
      turn.setFromUnitVectors(Z, along.clone().normalize());
      const size = new THREE.Vector3(0.16 * unit, 0.16 * unit, along.length());
      this.rods.setMatrixAt(index, place.compose(from.add(to).multiplyScalar(0.5), turn, size));
    });
    const points = axes.flatMap((one) => (one.point ? [one.point] : [])).slice(0, MOST);
    points.forEach((point, index) => this.balls.setMatrixAt(index, place.makeScale(unit, unit, unit).setPosition(...point)));
    this.rods.count = lines.length;
    this.balls.count = points.length;
    for (const mesh of [this.rods, this.balls]) mesh.instanceMatrix.needsUpdate = true;
    return axes.flatMap(({ lines, point, words }): Label[] => {
      const at = point ?? lines[0]?.[1];
      return at ? [{ point: at, text: words, kind: "axes", color: css(color("deciding")) }] : [];
    });
  }

  /** Ends of the rods and centers of the balls, as they are drawn: for tests. */
  read(): { lines: [Point, Point][]; points: Point[] } {
    const place = new THREE.Matrix4();
    const at = (mesh: THREE.InstancedMesh, index: number, z: number): Point => {
      mesh.getMatrixAt(index, place);
      return new THREE.Vector3(0, 0, z).applyMatrix4(place).toArray();
    };
    return {
      lines: Array.from({ length: this.rods.count }, (_, index) => [at(this.rods, index, -0.5), at(this.rods, index, 0.5)]),
      points: Array.from({ length: this.balls.count }, (_, index) => at(this.balls, index, 0)),
    };
  }
}
