// The ground with its soft shadow: the copy seen from below into a small picture, blurred by its smaller versions.
import {
  LinearFilter, LinearMipmapLinearFilter, Mesh, OrthographicCamera, PlaneGeometry, Scene, ShaderMaterial, Vector2, Vector3,
  type WebGLRenderer, WebGLRenderTarget,
} from "three";
import { nice } from "../delays";
import { inSoftware } from "./quality";
import { defines, ground, shade } from "./shaders";
import type { Moving } from "./shape";

const SIZE = inSoftware() ? 128 : 256;

export class Ground {
  readonly mesh: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly target = new WebGLRenderTarget(SIZE, SIZE, {
    minFilter: LinearMipmapLinearFilter, magFilter: LinearFilter, generateMipmaps: true, depthBuffer: true,
  });
  private readonly scene = new Scene();
  private readonly camera: OrthographicCamera;
  private readonly cast: Mesh | null = null;
  private readonly shade: ShaderMaterial;

  /**
   * @param low height of the object's lowest point at rest [m]
   * @param floor height of what it can rest on; null: nothing [m]
   */
  constructor(centre: Vector3, low: number, radius: number, skinned: Moving | null, floor: number | null) {
    const height = floor ?? low - 0.1 * radius;
    const reach = 2 * radius;
    this.mesh = new Mesh(
      new PlaneGeometry(9 * radius, 9 * radius),
      new ShaderMaterial({
        defines: defines(),
        vertexShader: ground.vertex, fragmentShader: ground.fragment, transparent: true, depthWrite: false,
        uniforms: {
          shadow: { value: this.target.texture }, centre: { value: new Vector2(centre.x, centre.y) },
          line: { value: new Vector3() }, dark: { value: new Vector3() },
          reach: { value: reach }, pitch: { value: nice(radius * 0.9) }, strength: { value: 0.3 }, opacity: { value: 0.5 },
          plate: { value: floor === null ? 0 : 0.16 },
        },
      }),
    );
    this.mesh.position.set(centre.x, centre.y, height);
    this.mesh.renderOrder = -1;
    // From below: x to the right, y down the picture.
    this.camera = new OrthographicCamera(-reach, reach, reach, -reach, 0, 12 * radius);
    this.camera.up.set(0, -1, 0);
    this.camera.position.set(centre.x, centre.y, height - radius);
    this.camera.lookAt(centre.x, centre.y, height);
    this.shade = new ShaderMaterial({
      vertexShader: shade.vertex, fragmentShader: shade.fragment, side: 2,
      uniforms: { scale: { value: 0 }, ground: { value: height }, reach: { value: 1.6 * radius } },
    });
    if (skinned) {
      this.cast = new Mesh(skinned.geometry, this.shade);
      this.cast.frustumCulled = false;
      this.scene.add(this.cast);
    }
  }

  colours(dark: boolean): void {
    const { line, dark: shadow, strength, opacity } = this.mesh.material.uniforms;
    if (dark) line!.value.set(0.62, 0.68, 0.78);
    else line!.value.set(0.36, 0.42, 0.52);
    if (dark) shadow!.value.set(0, 0, 0.01);
    else shadow!.value.set(0.1, 0.12, 0.2);
    strength!.value = dark ? 0.62 : 0.34;
    opacity!.value = dark ? 0.2 : 0.26;
  }

  /** Draws a copy's shadow for what is drawn next. */
  shadow(renderer: WebGLRenderer, of: Moving, scale: number): void {
    if (!this.cast) return;
    this.cast.geometry = of.geometry;
    this.shade.uniforms.scale!.value = scale;
    renderer.setRenderTarget(this.target);
    renderer.clear();
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(null);
  }

  dispose(): void {
    this.target.dispose();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.shade.dispose();
  }
}
