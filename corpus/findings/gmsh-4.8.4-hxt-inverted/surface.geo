Merge "surface.surface.msh";
Surface Loop(1) = {1};
Surface Loop(2) = {2};
Volume(1) = {1};
Volume(2) = {2};
