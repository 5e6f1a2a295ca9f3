// A slab of ior 2 inside a slab of ior 1.5, before a white wall: POV-Ray has no Fresnel reflection on leaving the inner one.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } conserve_energy } }
box { <-9, -9, 4>, <9, 9, 5> pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }
box { <-9, -9, -1>, <9, 9, 1> texture { Clear } interior { ior 1.5 } }
box { <-8, -8, -0.5>, <8, 8, 0.5> texture { Clear } interior { ior 2 } }
