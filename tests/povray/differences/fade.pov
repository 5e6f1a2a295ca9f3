// A white ball in absorbing glass: POV-Ray drops the fading on a way that ends on another object.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 }
camera { location -5*z look_at 0 right 4/3*x angle 30 }
box {
    <-9, -9, -1>, <9, 9, 1>
    pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
    interior { ior 1.0001 fade_distance 1 fade_power 1001 fade_color rgb 0.5 }
}
sphere { 0, 0.5 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }
