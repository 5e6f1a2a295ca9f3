// A pane 5e-5 thick before a white wall: POV-Ray sees no hit nearer than 1e-4, and the pane has no back to it.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
box { <-9, -9, 4>, <9, 9, 5> pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }
box {
    <-9, -9, 0>, <9, 9, 5e-5>
    texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } conserve_energy } }
    interior { ior 1.5 }
}
