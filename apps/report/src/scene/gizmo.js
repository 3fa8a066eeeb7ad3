import { AmbientLight, CanvasTexture, PerspectiveCamera, Scene, SRGBColorSpace, Sprite, SpriteMaterial, Vector3 } from "three";
import { makeArrow } from "./arrows.js";
import { axisColours } from "../theme.js";

const pixels = 84;
const axes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];

// The global axes, in the corner at the lower left.
export class Gizmo {
  constructor() {
    this.scene = new Scene();
    this.scene.add(new AmbientLight(0xffffff, 3));
    this.camera = new PerspectiveCamera(30, 1, 0.1, 20);
    axes.forEach((axis, i) => {
      const arrow = makeArrow(axisColours[i], 1, 0.045);
      arrow.quaternion.setFromUnitVectors(axes[2], axis);
      const label = new Sprite(new SpriteMaterial({ map: drawLetter("xyz"[i], axisColours[i]) }));
      label.position.copy(axis).multiplyScalar(1.28);
      label.scale.setScalar(0.5);
      this.scene.add(arrow, label);
    });
  }

  draw(renderer, camera) {
    this.camera.quaternion.copy(camera.quaternion);
    this.camera.position.set(0, 0, 6.2).applyQuaternion(camera.quaternion);
    renderer.autoClear = false;
    renderer.clearDepth();
    renderer.setViewport(6, 6, pixels, pixels);
    renderer.render(this.scene, this.camera);
    renderer.autoClear = true;
  }
}

function drawLetter(letter, colour) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d");
  pen.font = "600 44px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillStyle = colour;
  pen.fillText(letter, 32, 32);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}
