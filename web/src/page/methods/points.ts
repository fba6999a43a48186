// SPDX-License-Identifier: MIT
/** Paragraphs on the material point method and its two formulations of pore water; formulas as in the theory pages of the manual. */
import { isOnAnywhere, quoteEach, quoteWhere } from "./settings";
import { prose, type MethodTexts } from "./writer";

/** The time step of the two-velocity formulation has another limit. */
const wetStep = prose`
  Where pore water flows, the step is that of the frictionless waves of both phases, which implicit drag can only
  lengthen (explicit drag shortens it further). With $\lambda=4/L_e^2$ it is the smallest root of
  $$\det\left(4\beta\mathbf M-\Delta t^2\lambda\mathbf K\right)=0,\quad \mathbf
  M=\begin{bmatrix}(1-n)\rho_s&\\&\theta\rho_w\end{bmatrix},\quad \mathbf
  K=\begin{bmatrix}E_c&\\&0\end{bmatrix}+\frac{S^2}{n(S/K_w-dS/dp)}\begin{bmatrix}1-n\\n\end{bmatrix}\begin{bmatrix}1-n&n\end{bmatrix}$$
  det(4 β M − Δt² λ K) = 0,  M = diag((1 − n) ρ_s, θ ρ_w),  K = diag(E_c, 0) + S² / (n (S/K_w − dS/dp)) [1 − n, n]ᵀ [1 −
  n, n] $$`;

const nodalAverage = prose`
  $$\Delta\bar\varepsilon_{vol,i}=\frac{\sum_{e\ni i}\Delta\varepsilon_{vol,e}V_e}{\sum_{e\ni i}V_e},\qquad
  \Delta\bar\varepsilon_{vol,e}=\frac1{D+1}\sum_{i\in e}\Delta\bar\varepsilon_{vol,i},\qquad
  \Delta\boldsymbol\varepsilon\leftarrow\Delta\boldsymbol\varepsilon+\tfrac13\left(\Delta\bar\varepsilon_{vol,e}-\Delta\varepsilon_{vol,e}\right)\mathbf
  I$$
  Δε̄_vol,i = Σ_e Δε_vol,e V_e / Σ_e V_e (elements e at node i),  Δε̄_vol,e = Σ_i Δε̄_vol,i / (D + 1) (nodes i of
  e),  Δε ← Δε + ⅓ (Δε̄_vol,e − Δε_vol,e) I $$`;

export const points = {
  material_point_method: ["Material point method", ({ model, methods, result: { input } }) => {
    const phases = methods.includes("two_phase")
      ? "Where the soil holds water this balance is that of soil and water together, and the water has one of its own, " +
        "below"
      : methods.includes("seeping")
        ? "Where the soil holds water this balance is that of soil and water together, which have one velocity"
        : "The soil is a single phase";
    const simplex = model.dimension === 2 ? "triangles" : "tetrahedra";
    const plane =
      model.dimension === 2
        ? " The analysis is in plane strain, with all quantities per metre of thickness; the stress normal to the " +
          "plane takes part in yielding."
        : "";
    const rotation =
      isOnAnywhere(input, "objective_rate") === false
        ? "Stress increments are added in fixed axes; stresses are not turned with the soil."
        : prose`
      Before each increment the stress is turned with the soil by the rotation of the step, in the form of Hughes and
      Winget [@hughes1980], with $\mathbf L=\sum_i\,\mathbf v_i\otimes\nabla N_i$:
      $$\boldsymbol\sigma\leftarrow\mathbf R\,\boldsymbol\sigma\,\mathbf R^{\mathsf T},\quad \mathbf R=\left(\mathbf
      I-\tfrac12\mathbf W\right)^{-1}\left(\mathbf I+\tfrac12\mathbf W\right),\quad \mathbf W=\tfrac12\Delta t\,(\mathbf
      L-\mathbf L^{\mathsf T})$$
      σ ← R σ Rᵀ,  R = (I − W/2)⁻¹ (I + W/2),  W = ½ Δt (L − Lᵀ) $$`;
    return prose`
      The motion of the soil was computed with the material point method [@sulsky1994]. The soil is represented by
      material points, which carry mass, velocity, stress and state through a fixed background mesh of linear
      ${simplex}.${plane} ${phases}; stresses are Cauchy stresses, positive in tension. In each explicit time step the
      balance of momentum is solved at the nodes $i$ of the mesh, with a lumped mass matrix, from sums over the points
      $p$ [@source]:
      $$m_i\,\mathbf a_i=\mathbf f_i^{\,ext}-\mathbf f_i^{\,int},\quad m_i=\sum_p m_pN_i,\quad \mathbf
      f_i^{\,ext}=\sum_p m_pN_i\,\mathbf g+\int_{\partial\Omega^{\tau}}N_i\,\hat{\boldsymbol\tau}\,dS,\quad \mathbf
      f_i^{\,int}=\sum_p V_p\,\boldsymbol\sigma_p\nabla N_i$$
      m_i a_i = f_i^ext − f_i^int,  m_i = Σ_p m_p N_i,  f_i^ext = Σ_p m_p N_i g + ∫ N_i τ dS,  f_i^int = Σ_p V_p σ_p
      ∇N_i $$
      The step is “modified update stress last” [@sulsky1995]: velocities of points are changed by nodal accelerations
      only; nodal velocities are formed anew from them, and move and strain the points:
      $$\mathbf v_p\leftarrow\mathbf v_p+\Delta t\sum_iN_i\mathbf a_i,\quad m_i\mathbf v_i=\sum_pm_pN_i\mathbf v_p,\quad
      \mathbf x_p\leftarrow\mathbf x_p+\Delta t\sum_iN_i\mathbf v_i,\quad \Delta\boldsymbol\varepsilon=\tfrac12\Delta
      t\sum_i(\mathbf v_i\otimes\nabla N_i+\nabla N_i\otimes\mathbf v_i)$$
      v_p ← v_p + Δt Σ_i N_i a_i,  m_i v_i = Σ_p m_p N_i v_p,  x_p ← x_p + Δt Σ_i N_i v_i,  Δε = ½ Δt Σ_i (v_i ⊗ ∇N_i +
      ∇N_i ⊗ v_i) $$

      ${rotation}`;
  }],
  two_phase: ["Soil and pore water", ({ result: { input } }) => {
    const damping = isOnAnywhere(input, "water_damping") ? quoteEach(input, "water_damping") : "";
    const explicit = quoteWhere(input, "drag", "explicit");
    const implicit = quoteWhere(input, "drag", "implicit") !== "" || !explicit;
    const differences = [
      implicit &&
        "with the difference of the velocities at the end of the step (implicit drag, solved in closed form at each " +
          "node), so that a low conductivity does not shorten the time step",
      explicit && `with that at its beginning (explicit drag)${implicit ? ` in ${explicit}` : ""}`,
    ].filter(Boolean);
    return prose`
      Soil and pore water were computed as two phases with a velocity each, $\mathbf v$ of the grains and $\mathbf w$ of
      the water, on one set of points that go with the grains [@source; @alkafaji2013; @ceccato2021]. Air is at
      atmospheric pressure. The pore pressure $p$ is counted like all stresses of these equations, positive in tension:
      $p>0$ is suction. With the porosity $n$, the degree of saturation $S$ and the content of water $\theta=nS$ the
      balances of momentum of water and of mixture are
      $$\rho_w\mathbf a_w=\operatorname{grad}p+\rho_w\mathbf g-\frac{\rho_wg}k\,\theta(\mathbf w-\mathbf v),\qquad
      (1-n)\rho_s\mathbf a_s+\theta\rho_w\mathbf a_w=\operatorname{div}\left(\boldsymbol\sigma'+\chi p\,\mathbf
      I\right)+\rho\,\mathbf g$$
      ρ_w a_w = grad p + ρ_w g − (ρ_w g / k) θ (w − v),  (1 − n) ρ_s a_s + θ ρ_w a_w = div(σ′ + χ p I) + ρ g $$
      with $k$ the conductivity and $\rho=(1-n)\rho_s+\theta\rho_w$. Without relative acceleration the first is Darcy's
      law. At the nodes $i$, with sums over points,
      $$\beta M_w\mathbf a_w=\mathbf F_w-\theta_iR\,(\mathbf w^*-\mathbf v^*),\qquad \beta M_s\mathbf a_s=\mathbf
      F-\theta_i\mathbf F_w+\theta_i^2R\,(\mathbf w^*-\mathbf v^*),\qquad R=\sum_p\frac{\rho_wg}{k_p}V_pN_i$$
      β M_w a_w = F_w − θ_i R (w* − v*),  β M_s a_s = F − θ_i F_w + θ_i² R (w* − v*),  R = Σ_p (ρ_w g / k_p) V_p N_i $$
      where $\mathbf F_w$ and $\mathbf F$ are the forces on the water, taken as if it filled the volume, and on the
      mixture, $M_w=\sum_p\rho_wV_pN_i$, $M_s=\sum_pm_pN_i$, and $\theta_i$ is the mass of water at the node over $M_w$.
      The drag was taken ${differences.join(", and ")}. Mass scaling $\beta$ multiplies the inertia of both phases and
      no weight.

      ${damping && `Local damping acts on the water as well, against its motion; its share was ${damping}.`}`;
  }],
  water_storage: ["Storage of water and pore pressure", () => prose`
    Each point carries the mass $m_w$ of its water. Water flows with the content of the nodes; the pore pressure is then
    the one at which the pores hold their water:
    $$m_w\leftarrow m_w-\rho_wV\,\Delta t\,\operatorname{div}\left[\theta(\mathbf w-\mathbf v)\right],\qquad
    p:\;S(p)\,e^{-p/K_w}=\frac{m_w}{\rho_w\left(V-m_p/\rho_s\right)}$$
    m_w ← m_w − ρ_w V Δt div[θ (w − v)],  p: S(p) exp(−p / K_w) = m_w / (ρ_w (V − m_p / ρ_s)) $$
    To first order this is the equation of storage, $C\,dp=S\,d\varepsilon_{vol}+\operatorname{div}[\theta(\mathbf
    w-\mathbf v)]\,dt$ with $C=nS/K_w-n\,dS/dp$, whose sum over steps would lose water at a wetting front. Porosity
    follows the volume of the point, $n=1-m_p/(\rho_sV)$. The points of a full element hold their water as one.`],
  seeping: ["Soil that water seeps through", ({ methods, result: { input } }) => {
    const where = methods.includes("two_phase") ? quoteWhere(input, "water", "seeps") : "";
    return prose`
      Pore water seeps${where ? ` in ${where}` : ""}: grains and water have one velocity $\mathbf v$, and water moves
      against the grains as Darcy's law says. The pore pressure $p$, counted positive in tension like all stresses of
      these equations, is continuous, with a value at each node. The motion of the step is predicted under the pressures
      of its start; those of its end are the ones at which pores and water agree:
      $$\left[C+P_\tau+\Delta t\,L_K+\tfrac{\Delta t^2}{\beta}B\,M^{-1}B^{\mathsf T}\right]\delta=\Delta t\,B\mathbf
      v^*-\Delta t\left(L_Kp+\sum_eV_eK\,\nabla N_i\cdot\rho_w\mathbf g\right)+\Delta t\,\hat q+H(p)-W$$
      [C + P_τ + Δt L_K + (Δt²/β) B M⁻¹ Bᵀ] δ = Δt B v* − Δt (L_K p + Σ_e V_e K ∇N_i · ρ_w g) + Δt q + H(p) − W $$
      Here $W$ is the water of a node's pores: its share of what the points carry, and water of its own, which fades as
      the soil moves past it. $H(p)$ is what these pores hold, $C=-dH/dp$, $L_K$ the conductance between nodes with
      $K=k/(\rho_wg)$, $B$ the growth of pores by motion, $M$ the masses of soil and water, and $\hat q$ what leaves
      through the surface. $P_\tau$ is a polynomial projection of the increments against patterns that no node feels
      [@dohrmann2004]. The equation is solved by conjugate gradients; neither the conductivity nor the stiffness of the
      water bounds the time step, which is that of the drained soil.`;
  }],
  time_step: ["Time step", ({ model, methods, result: { input } }) => {
    const courant = quoteEach(input, "courant");
    return prose`
      The time step is a share $C$ (the Courant number) of the time in which a compression wave crosses the smallest
      element:
      $$\Delta t=C\,\min_e\frac{L_e}{c_e},\qquad c_e=\sqrt{\frac{E_c}{\beta\rho}},\qquad
      E_c=\frac{E(1-\nu)}{(1+\nu)(1-2\nu)}$$
      Δt = C min_e (L_e / c_e),  c_e = √(E_c / (β ρ)),  E_c = E (1 − ν) / ((1 + ν)(1 − 2ν)) $$
      Here $L_e$ is the smallest altitude of the ${model.dimension === 2 ? "triangle" : "tetrahedron"}, $\rho$ the
      present density, and $\beta$ the mass scaling, 1 unless stated; the minimum is taken over elements that hold soil
      and their neighbours, and is found again as the soil moves.${courant ? ` The Courant number was ${courant}.` : ""}

      ${methods.includes("two_phase") ? wetStep : ""}`;
  }],
  mixed_integration: ["Mixed integration", () => prose`
    Internal forces were integrated in the mixed way [@source]: elements that are full of soil of one material as in
    finite elements with one Gauss point, from the mean of the stresses of their points; all others over the material
    points:
    $$\mathbf f_i^{\,int}=\begin{cases}V_e\,\bar{\boldsymbol\sigma}_e\nabla N_i,\quad
    \bar{\boldsymbol\sigma}_e=\dfrac{\sum_pV_p\boldsymbol\sigma_p}{\sum_pV_p}&\text{full
    element}\\[1ex]\sum_pV_p\,\boldsymbol\sigma_p\nabla N_i&\text{otherwise}\end{cases}$$
    f_i^int = V_e σ̄_e ∇N_i with σ̄_e = Σ_p V_p σ_p / Σ_p V_p in a full element;  f_i^int = Σ_p V_p σ_p ∇N_i otherwise
    $$
    An element is full inside the soil, and at the free surface when the volume of its points exceeds 90 % of its own.
    The points of a full element share one state. Integration over the whole element does not conserve energy exactly.`],
  point_integration: ["Integration over points", () => prose`
    Internal forces were integrated over the material points in every element [@sulsky1994]:
    $$\mathbf f_i^{\,int}=\sum_pV_p\,\boldsymbol\sigma_p\nabla N_i$$ f_i^int = Σ_p V_p σ_p ∇N_i $$
    The force of a point jumps to other nodes when it crosses a side of the mesh, which shows as noise in the stresses.`],
  strain_smoothing: ["Smoothing of volumetric strain", () => prose`
    Volumetric locking of the linear elements was reduced by averaging the volumetric strain increment over the nodes
    and back, as in nodal mixed discretisation [@detournay2006], over elements that hold soil:

    ${nodalAverage}

    $D$ is the dimension; the deviatoric part is not changed. With dilatancy this plain form can grow unstable; it is
    meant for a dilatancy angle of zero.`],
  stable_smoothing: ["Stable smoothing", ({ methods }) => prose`
    ${methods.includes("strain_smoothing") ? prose`
      Where the stable form of smoothing was used, the volumetric strain increment was averaged in the same way.` : prose`
      Volumetric locking of the linear elements was removed by averaging the volumetric strain increment over the nodes
      and back, as in nodal mixed discretisation [@detournay2006], over elements that hold soil ($D$ is the dimension):

      ${nodalAverage}`}

    In addition the change of mean stress by the plastic return, $\Delta p^r$, is averaged in the same way (mean over
    the element, to the nodes, and back), and each element receives the difference. Without it the averaged strain and
    the return in answer to shear do not balance within an element where the soil dilates:
    $$\boldsymbol\sigma_p\leftarrow\boldsymbol\sigma_p+\left(\Delta\bar p^{\,r}_e-\Delta p^{\,r}_e\right)\mathbf
    I,\qquad \Delta p^{\,r}=p(\boldsymbol\sigma^{new})-p(\boldsymbol\sigma^{tr})$$
    σ_p ← σ_p + (Δp̄ʳ_e − Δpʳ_e) I,  Δpʳ = p(σ_new) − p(σ_trial) $$`],
  pressure_smoothing: ["Smoothing of pore pressures", () => prose`
    Pore pressures were smoothed by averaging what makes them rise, $\Delta\zeta_e=S\Delta\varepsilon_{vol}+\Delta
    t\operatorname{div}[\theta(\mathbf w-\mathbf v)]$, over the nodes and back. This moves water between neighbours and
    loses none:
    $$m_w\leftarrow m_w-\rho_wV_p\left(\Delta\bar\zeta_e-\Delta\zeta_e\right)$$ m_w ← m_w − ρ_w V_p (Δζ̄_e − Δζ_e) $$`],
  local_damping: ["Local damping", ({ result: { input } }) => {
    const damping = quoteEach(input, "damping");
    return prose`
      Local damping after Cundall [@itasca] acts at every node and in every direction against the motion, in proportion
      to the unbalanced force:
      $$\mathbf f_i^{\,damp}=-\alpha\,\operatorname{sign}(\mathbf p_i)\,\bigl|\mathbf f_i^{\,ext}-\mathbf
      f_i^{\,int}\bigr|,\qquad \mathbf p_i=\sum_pm_pN_i\mathbf v_p$$
      f_i^damp = −α sign(p_i) |f_i^ext − f_i^int|,  p_i = Σ_p m_p N_i v_p $$
      It is added to the right side of the balance of momentum. It vanishes with the unbalanced force and so does not
      change a state of rest; during motion it takes energy out of the
      soil.${damping ? ` The damping $\\alpha$ was ${damping}.` : ""}`;
  }],
  mass_scaling: ["Mass scaling", ({ result: { input } }) => {
    const scaling = quoteEach(input, "mass_scaling");
    return prose`
      To settle the soil in fewer steps its inertia, and only that, was multiplied by a factor $\beta$:
      $$\mathbf a_i=\frac{\mathbf f_i}{\beta\,m_i},\qquad \Delta t_{cr}\propto\sqrt\beta$$
      a_i = f_i / (β m_i),  Δt_cr ∝ √β $$
      Weight and momentum keep the real masses. States of rest are not affected; velocities during the scaled stages are
      not real.${scaling ? ` The factor $\\beta$ was ${scaling}.` : ""}`;
  }],
} satisfies MethodTexts;
