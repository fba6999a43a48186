// SPDX-License-Identifier: MIT
/** References of the methods section: the key of each, and its text. */
const list = `
source: Aldakhil, S. K. (2026). Application of the Material Point Method to the Stability and Runout Analysis of
  Vegetated Slopes. Dissertation, University of California, Los Angeles. “The source” of the Talus manual: formulation
  in chapter 2, strength reduction in chapter 3, rooted soil in chapter 4.
bishop1954: Bishop, A. W. (1954). The use of pore-pressure coefficients in practice. Géotechnique 4 (4), 148–152.
duncan1990: Duncan, J. M., Wright, S. G., Wong, K. S. (1990). Slope stability during rapid drawdown. Proceedings of the
  H. Bolton Seed Memorial Symposium 2, 253–272.
usace2003: US Army Corps of Engineers (2003). Slope stability. Engineer Manual EM 1110-2-1902, appendix G.
drucker1952: Drucker, D. C., Prager, W., Greenberg, H. J. (1952). Extended limit design theorems for continuous media.
  Quarterly of Applied Mathematics 9, 381–389.
lyamin2002: Lyamin, A. V., Sloan, S. W. (2002). Lower bound limit analysis using non-linear programming. International
  Journal for Numerical Methods in Engineering 55, 573–611.
sulsky1994: Sulsky, D., Chen, Z., Schreyer, H. L. (1994). A particle method for history-dependent materials. Computer
  Methods in Applied Mechanics and Engineering 118, 179–196.
sulsky1995: Sulsky, D., Zhou, S.-J., Schreyer, H. L. (1995). Application of a particle-in-cell method to solid
  mechanics. Computer Physics Communications 87, 236–252.
hughes1980: Hughes, T. J. R., Winget, J. (1980). Finite rotation effects in numerical integration of rate constitutive
  equations arising in large-deformation analysis. International Journal for Numerical Methods in Engineering 15,
  1862–1867.
itasca: Itasca Consulting Group. FLAC – Fast Lagrangian Analysis of Continua, Theory and Background (local damping after
  P. Cundall). Minneapolis.
detournay2006: Detournay, C., Dzik, E. (2006). Nodal mixed discretization for tetrahedral elements. Proceedings of the
  4th International FLAC Symposium on Numerical Modeling in Geomechanics, Madrid.
clausen2007: Clausen, J., Damkilde, L., Andersen, L. (2007). An efficient return algorithm for non-associated plasticity
  with linear yield criteria in principal stress space. Computers and Structures 85, 1795–1807.
roscoe1968: Roscoe, K. H., Burland, J. B. (1968). On the generalized stress–strain behaviour of wet clay. In:
  Engineering Plasticity, Cambridge University Press, 535–609.
tamagnini2004: Tamagnini, R. (2004). An extended Cam-clay model for unsaturated soils with hydraulic hysteresis.
  Géotechnique 54 (3), 223–228.
borja1990: Borja, R. I., Lee, S. R. (1990). Cam-Clay plasticity, part I: implicit integration of elasto-plastic
  constitutive relations. Computer Methods in Applied Mechanics and Engineering 78, 49–72.
switala2018: Świtała, B. M., Askarinejad, A., Wu, W., Springman, S. M. (2018). Experimental validation of a coupled
  hydro-mechanical model for vegetated soil. Géotechnique 68 (5), 375–385.
wu1979: Wu, T. H., McKinnell, W. P., Swanston, D. N. (1979). Strength of tree roots and landslides on Prince of Wales
  Island, Alaska. Canadian Geotechnical Journal 16, 19–33.
waldron1977: Waldron, L. J. (1977). The shear resistance of root-permeated homogeneous and stratified soil. Soil Science
  Society of America Journal 41, 843–849.
pollen2005: Pollen, N., Simon, A. (2005). Estimating the mechanical effects of riparian vegetation on stream bank
  stability using a fiber bundle model. Water Resources Research 41, W07025.
matsui1992: Matsui, T., San, K.-C. (1992). Finite element slope stability analysis by shear strength reduction
  technique. Soils and Foundations 32 (1), 59–70.
griffiths1999: Griffiths, D. V., Lane, P. A. (1999). Slope stability analysis by finite elements. Géotechnique 49 (3),
  387–403.
feng2021: Feng and Xu (2021). Bilinear construction on the curve of displacement over strength reduction factor; as used
  in the source.
alkafaji2013: Al-Kafaji, I. K. J. (2013). Formulation of a dynamic material point method (MPM) for geomechanical
  problems. Dissertation, Universität Stuttgart.
ceccato2021: Ceccato, F., Yerro, A., Girardi, V., Simonini, P. (2021). Two-phase dynamic MPM formulation for unsaturated
  soil. Computers and Geotechnics 129, 103876.
dohrmann2004: Dohrmann, C. R., Bochev, P. B. (2004). A stabilized finite element method for the Stokes problem based on
  polynomial pressure projections. International Journal for Numerical Methods in Fluids 46 (2), 183–201.
bishop1959: Bishop, A. W. (1959). The principle of effective stress. Teknisk Ukeblad 106 (39), 859–863.
khalili1998: Khalili, N., Khabbaz, M. H. (1998). A unique relationship for χ for the determination of the shear strength
  of unsaturated soils. Géotechnique 48 (5), 681–687.
vangenuchten1980: van Genuchten, M. Th. (1980). A closed-form equation for predicting the hydraulic conductivity of
  unsaturated soils. Soil Science Society of America Journal 44, 892–898.
mualem1976: Mualem, Y. (1976). A new model for predicting the hydraulic conductivity of unsaturated porous media. Water
  Resources Research 12 (3), 513–522.
duncan2014: Duncan, J. M., Wright, S. G., Brandon, T. L. (2014). Soil Strength and Slope Stability. 2nd edition, Wiley,
  Hoboken.
fellenius1936: Fellenius, W. (1936). Calculation of the stability of earth dams. Transactions of the 2nd Congress on
  Large Dams, Washington, 4, 445–462.
bishop1955: Bishop, A. W. (1955). The use of the slip circle in the stability analysis of slopes. Géotechnique 5 (1),
  7–17.
janbu1973: Janbu, N. (1973). Slope stability computations. In: Embankment-Dam Engineering, Casagrande Volume, Wiley, New
  York, 47–86.
spencer1967: Spencer, E. (1967). A method of analysis of the stability of embankments assuming parallel inter-slice
  forces. Géotechnique 17 (1), 11–26.
morgenstern1965: Morgenstern, N. R., Price, V. E. (1965). The analysis of the stability of general slip surfaces.
  Géotechnique 15 (1), 79–93.
mckay1979: McKay, M. D., Beckman, R. J., Conover, W. J. (1979). A comparison of three methods for selecting values of
  input variables in the analysis of output from a computer code. Technometrics 21 (2), 239–245.
clopper1934: Clopper, C. J., Pearson, E. S. (1934). The use of confidence or fiducial limits illustrated in the case of
  the binomial. Biometrika 26 (4), 404–413.
hasofer1974: Hasofer, A. M., Lind, N. C. (1974). Exact and invariant second-moment code format. Journal of the
  Engineering Mechanics Division, ASCE, 100, 111–121.
en1997: EN 1997-1 (2004). Eurocode 7: Geotechnical design – Part 1: General rules. CEN, Brussels.
hillel1971: Hillel, D. (1971). Soil and Water: Physical Principles and Processes. Academic Press, New York.
gardner1958: Gardner, W. R. (1958). Some steady-state solutions of the unsaturated moisture flow equation with
  application to evaporation from a water table. Soil Science 85, 228–232.
`;

export const references = new Map(
  list
    .trim()
    .split(/\n(?! )/)
    .map((entry): [string, string] => {
      const [key = "", ...text] = entry.replace(/\n +/g, " ").split(": ");
      return [key, text.join(": ")];
    }),
);
