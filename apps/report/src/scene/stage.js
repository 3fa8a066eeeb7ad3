import { AmbientLight, DirectionalLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three";
import { Gizmo } from "./gizmo.js";

const fieldOfView = 32;
const stepsBack = [1, 1.2, 1.5, 2, 2.7, 3.6, 5, 7, 10, 14];

// The canvas with its camera: turns, zooms and pans, and draws when something has changed.
export class Stage {
  constructor(canvas) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", () => this.draw());
    this.controls.addEventListener("start", () => (this.isOwnView = true));
    this.gizmo = new Gizmo();
    this.addLights();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  addLights() {
    this.scene.add(new AmbientLight(0xffffff, 1.1));
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(0.6, 1, 0.9);
    const rim = new DirectionalLight(0xffffff, 0.5);
    rim.position.set(-1, -0.4, 0.3);
    this.camera.add(sun, rim);
    this.scene.add(this.camera);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement.parentElement;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.makeRoom(width, height);
    if (!this.isOwnView && this.box) this.fit();
    this.draw();
  }

  // The box is shown below what lies over the canvas at its top: the legend.
  makeRoom(width, height) {
    const covered = Math.min(this.covered?.() ?? 0, 0.4 * height);
    this.camera.aspect = width / (height - covered);
    // Of a view of the free part, which the canvas goes beyond at its top.
    this.camera.setViewOffset(width, height - covered, 0, -covered, width, height);
  }

  // What fit() shows: [least, largest] corners.
  setBox([least, largest]) {
    this.box = [new Vector3(...least), new Vector3(...largest)];
    this.centre = this.box[0].clone().add(this.box[1]).multiplyScalar(0.5);
  }

  // Looks along a direction, with another pointing up, so that the whole box is seen.
  look(direction, up) {
    this.isOwnView = false;
    this.camera.up.set(...up);
    this.direction = new Vector3(...direction).normalize();
    this.fit();
  }

  fit() {
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement.parentElement;
    if (width > 0 && height > 0) this.makeRoom(width, height);
    if (this.direction) this.camera.position.copy(this.centre).sub(this.direction);
    const back = this.camera.position.clone().sub(this.controls.target).normalize();
    if (this.direction) back.copy(this.direction).negate();
    this.controls.target.copy(this.centre);
    this.camera.position.copy(this.centre).add(back);
    this.camera.lookAt(this.centre);
    this.stepBack(back, this.distanceFor(back));
    const radius = this.box[0].distanceTo(this.box[1]);
    this.camera.near = radius / 500;
    this.camera.far = radius * 100;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  // To a distance from the centre, or farther if that is inside an obstacle: `hides` says so of a point. In one that is much larger than the model it stays.
  stepBack(back, distance) {
    const placeAt = (factor) => this.centre.clone().addScaledVector(back, factor * distance);
    const free = stepsBack.find((factor) => !this.hides?.(placeAt(factor)));
    this.steps = free === undefined ? stepsBack.length : stepsBack.indexOf(free);
    this.camera.position.copy(placeAt(free ?? 1));
  }

  // The distance from which all corners of the box are within the picture, with a margin.
  distanceFor(back) {
    const tangent = Math.tan((fieldOfView * Math.PI) / 360) * 0.84;
    const right = new Vector3().setFromMatrixColumn(this.camera.matrix, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrix, 1);
    let distance = 0;
    for (let i = 0; i < 8; i++) {
      const corner = new Vector3(this.box[i & 1].x, this.box[(i >> 1) & 1].y, this.box[(i >> 2) & 1].z).sub(this.centre);
      const depth = corner.dot(back);
      const across = Math.max(Math.abs(corner.dot(right)) / this.camera.aspect, Math.abs(corner.dot(up)));
      distance = Math.max(distance, depth + across / tangent);
    }
    return distance;
  }

  // At the next picture of the screen.
  draw() {
    if (this.isDue) return;
    this.isDue = true;
    requestAnimationFrame(() => {
      this.isDue = false;
      this.renderer.setViewport(0, 0, this.renderer.domElement.clientWidth, this.renderer.domElement.clientHeight);
      this.renderer.render(this.scene, this.camera);
      this.gizmo.draw(this.renderer, this.camera);
    });
  }
}
