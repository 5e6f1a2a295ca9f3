// expect rmse 2e-4: POV-Ray looks for the roots of a lathe to 1e-4 only
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 1.6, -5> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.7, 0.6> rgb <0.2, 0.3, 0.4> scale 0.5 } finish { ambient 0.1 diffuse 0.6 } }
lathe { linear_spline 6, <0.1, 0>, <0.5, 0.05>, <0.3, 0.4>, <0.6, 0.9>, <0.45, 1.3>, <0.2, 1.4> pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.4 } translate <-1.4, 0, 0> }
lathe { quadratic_spline 6, <0.1, 0>, <0.5, 0.05>, <0.3, 0.4>, <0.6, 0.9>, <0.45, 1.3>, <0.2, 1.4> pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.4 } translate <0, 0, 0> }
lathe { cubic_spline 6, <0.1, 0>, <0.5, 0.05>, <0.3, 0.4>, <0.6, 0.9>, <0.45, 1.3>, <0.2, 1.4> pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.4 } translate <1.4, 0, 0> }
