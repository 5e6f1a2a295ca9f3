// The same glass in contact, for POV-Ray: the water reaches 1e-4 into the wall, and neither is seen where it ends inside the other.
#version 3.7;
#include "studio.inc"
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } conserve_energy } }
#declare Unseen = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#declare Glass = difference {
    cylinder { <0, 0, 0>, <0, 1.6, 0>, 0.8 }
    cylinder { <0, 0.15, 0>, <0, 2, 0>, 0.7 }
}
#declare Water = difference {
    cylinder { <0, 0.1499, 0>, <0, 1.2, 0>, 0.7001 }
    sphere { <-0.3, 0.6, -0.2>, 0.16 }
    sphere { <0.25, 0.9, 0.1>, 0.1 }
}
object { Glass texture { Clear } interior_texture { object { Water texture { Clear } texture { Unseen } } } interior { ior 1.5 } }
object { Water texture { Clear } interior_texture { object { Glass texture { Clear } texture { Unseen } } } interior { ior 1.33 } }
