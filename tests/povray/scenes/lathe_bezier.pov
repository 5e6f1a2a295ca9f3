// expect rmse 2e-4: POV-Ray looks for the roots of a lathe to 1e-4 only
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 1.6, -5> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.7, 0.6> rgb <0.2, 0.3, 0.4> scale 0.5 } finish { ambient 0.1 diffuse 0.6 } }
lathe { bezier_spline 12, <0, 0.05>, <0.3, 0.05>, <0.6, 0.1>, <0.6, 0.4>, <0.6, 0.4>, <0.6, 0.8>, <0.2, 0.9>, <0.3, 1.4>, <0.3, 1.4>, <0.25, 1.45>, <0.1, 1.5>, <0, 1.5> pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.4 } translate <-0.7, 0, 0> }
lathe { linear_spline 6, <0, 0.1>, <0.4, 0.1>, <0.5, 0.9>, <0.3, 1.2>, <0, 1.2>, <0, 0.1> pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.4 } translate <0.7, 0, 0> }
