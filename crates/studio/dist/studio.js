var kt,im,ey,Qs,ad,kl,sm,Nl,rm,ud,ld,om,xa=Symbol.for("pv"),Bl={},zl=[],ty=/^m(i|n|o|s|text|space)$/,hd=Array.isArray,am=zl.slice,Rr=Object.assign;function Cr(n){n&&n.parentNode&&n.remove()}function Fl(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:xa,__v:s||++im,__i:-1,__u:0};return!s&&kt.vnode&&kt.vnode(r),r}function xt(n){return n.children}function Ul(n,e){this.props=n,this.context=e,this.__g=0}function js(n,e){if(e==null)return n.__&&js(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:js(n)}function ny(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Rr({constructor:xa},t)).__v=t.__v+1,kt.vnode&&kt.vnode(e),dd(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||js(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,fm(s,e,r),t.__=t.__e=null,e.__e!=i&&lm(e))}function lm(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),lm(n)}function cd(n){(8&n.__g||(n.__g|=8,Qs.push(n),kl++))&&ad==kt.debounceRendering||((ad=kt.debounceRendering)||queueMicrotask)(cm)}function cm(){try{for(var n,e=1;Qs.length;)Qs.length>e&&Qs.sort(sm),n=Qs.shift(),e=Qs.length,8&n.__g&&ny(n)}finally{(kl=Qs.length)&&(ad||queueMicrotask)(cm)}}function um(n,e,t,i,s,r,o,a,l,c,u){var h,d,f,g,y,p,m=i.__k||zl,v=e.length;for(l=iy(t,e,m,l,v),h=0;h<v;h++)(f=t.__k[h])!=null&&(d=~f.__i&&m[f.__i]||Bl,f.__i=h,p=dd(n,f,d,s,r,o,a,l,c,u),g=f.__e,(d.ref!=f.ref||8&d.__u)&&(d.ref&&fd(d.ref,null,f,d),f.ref&&u.push(f.ref,f.__c||g,f)),y=y||g,4&f.__u?(l=hm(f,l,n,!d.__v),d.__e&&(d.__e=null)):typeof f.type=="function"&&p!==void 0?l=p:g&&(l=g.nextSibling),f.__u&=-21);return t.__e=y,l}function iy(n,e,t,i,s){var r,o,a,l,c,u,h,d,f,g=t.length,y=g,p=0,m=0,v=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=v[r]=Fl(null,o):hd(o)?o=v[r]=Fl(xt,{children:o}):o.constructor===xa&&o.__b?o=v[r]=Fl(o.type,o.props,o.key,o.ref,o.__v):v[r]=o,l=r+p,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=sy(o,t,l,y))&&(y--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?p--:c==l+1?p++:c!=l&&(c>l?p--:p++,m=1)):(~c||(s>g?p--:s<g&&p++),typeof o.type!="function"&&(o.__u|=4))):v[r]=null;if(m){for(u=[],h=[],r=0;r<s;r++)if((o=v[r])&&16&o.__u){for(p=0,d=u.length;p<d;)u[f=p+d>>1]<o.__i?p=f+1:d=f;u[p]=o.__i,h[r]=p+1}for(p=u.length;r--;)h[r]&&(h[r]==p?p--:v[r].__u|=4)}if(y)for(r=0;r<g;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=js(a)),pd(a,a));return i}function hm(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=hm(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=js(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function sy(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function nm(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Dl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||nm(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||nm(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=ld[e]||(ld[e]=ry(e)),(n.__a||(n.__a={}))[e]=ud,r=e!=(e=e.replace(rm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function ry(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Nl]==null)e[Nl]=ud++;else if(e[Nl]<this.__a[n])return;return t(kt.event?kt.event(e):e)}}}function dd(n,e,t,i,s,r,o,a,l,c){var u,h,d,f,g,y,p,m,v,E,S,R,C,x,w,O,I,D,z=e.type;if(e.constructor!==xa)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=Ol(u,r):r.push(u),a=r[0]||a),(u=kt.__b)&&u(e);e:if(typeof z=="function"){d=o.length;try{if(m=e.props,v=(u=z.prototype)&&u.render,E=(u=z.contextType)&&i[u.__c],S=u?E?E.props.value:u.__:i,(f=t.__c)?(e.__c=f,2&f.__g&&(f.__g|=1)):(v?e.__c=f=new z(m,S):(e.__c=f=new Ul(m,S),f.constructor=z,f.render=ay),E&&E.sub(f),f.state||(f.state={}),f.__n=i,f.__g|=8,f.__h=[],f.__k=[]),v&&(f.__s||(f.__s=f.state),z.getDerivedStateFromProps&&(f.__s==f.state&&(f.__s=Rr({},f.__s)),Rr(f.__s,z.getDerivedStateFromProps(m,f.__s)))),g=f.props,y=f.state,f.__v=e,t.__c){if(m!==g&&v&&!z.getDerivedStateFromProps&&f.componentWillReceiveProps&&f.componentWillReceiveProps(m,S),e.__v==t.__v&&!(8&f.__g)||!(4&f.__g)&&f.shouldComponentUpdate&&f.shouldComponentUpdate(m,f.__s,S)===!1){e.__v!=t.__v&&(f.props=m,f.state=f.__s,f.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(G){G&&(G.__=e)}),zl.push.apply(f.__h,f.__k),f.__k=[],f.__h.length&&o.push(f),a=js(t);break e}f.componentWillUpdate&&f.componentWillUpdate(m,f.__s,S),v&&f.componentDidUpdate&&f.__h.push(function(){f.componentDidUpdate(g,y,p)})}else v&&!z.getDerivedStateFromProps&&f.componentWillMount&&f.componentWillMount(),v&&f.componentDidMount&&f.__h.push(f.componentDidMount);f.context=S,f.props=m,f.__P=n,f.__g&=-5,R=kt.__r,C=v?25:0;do f.__g&=-9,R&&R(e),u=f.render(f.props,f.state=f.__s,f.context);while(8&f.__g&&++C<25);v&&(zl.push.apply(f.__h,f.__k),f.__k=[]),f.state=f.__s,f.getChildContext&&(i=Rr({},i,f.getChildContext())),v&&t.__c&&f.getSnapshotBeforeUpdate&&(p=f.getSnapshotBeforeUpdate(g,y)),x=u&&u.type===xt&&u.key==null?u.props.children:u,m.__P&&(u=a,s=(n=m.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(G){G&&pd(G,G)}),t.__k=null),a=t.__k?js(t,0):null),a=um(n,hd(x)?x:[x],e,t,i,s,r,o,a,l,c),m.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(Cr),f.__h.length&&o.push(f),1&f.__g&&(f.__g&=-4)}catch(G){if(o.length=d,e.__v=null,l||r)if(G&&G.then){if(e.__u|=128|l,r){for(~(I=r.indexOf(a||void 0))||(I=r.length);(D=r[I-1])&&D.nodeType==8;)I--;for(;I<r.length;I++)if(D=r[I])if(r[I]=null,w){if(D==O)break}else{if(D.nodeType!=8)break;D.data.startsWith("$s")&&(O=Ol(w=D))}}if(!w){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;w=a}(u=Ol(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Cr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),G&&G.then||dm(e),kt.__e(G,e,t)}}else a=e.__e=oy(t.__e,e,t,i,s,r,o,l,c,n);return(u=kt.diffed)&&u(e),a}function Ol(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function dm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(dm))}function fm(n,e,t){for(var i=0;i<t.length;)fd(t[i++],t[i++],t[i++]);kt.__c&&kt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){kt.__e(r,s.__v)}})}function oy(n,e,t,i,s,r,o,a,l,c){var u,h,d,f,g,y,p,m,v=t.props||Bl,E=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((g=r[u])&&(S?g.localName==S:g.nodeType==3)){n=g,r[u]=null;break}}if(!n){if(m=c.ownerDocument||document,!S)return m.createTextNode(E);n=m.createElementNS(s,S,E.is?E:c),a&&(kt.__m&&kt.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&E.defaultValue!=null?null:r&&am.call(c.childNodes),!a&&r)for(v={},u=0;u<n.attributes.length;u++)v[(g=n.attributes[u]).name]=g.value;for(u in v)g=v[u],u=="dangerouslySetInnerHTML"?d=g:u=="children"||u in E||u=="value"&&"defaultValue"in E||u=="checked"&&"defaultChecked"in E||Dl(n,u,null,g,s);for(u in E)g=E[u],u=="children"?f=g:u=="dangerouslySetInnerHTML"?h=g:u=="value"?y=g:u=="checked"?p=g:a&&typeof g!="function"||v[u]===g||Dl(n,u,g,v[u],s);h?(a||d&&(h.__html==d.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(d&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&ty.test(S))&&(s="http://www.w3.org/1999/xhtml"),um(c,hd(f)?f:[f],e,t,i,s,r,o,r?r[0]:t.__k&&js(t,0),a,l),r&&r.some(Cr)),a&&S!="textarea"||(u="value",S=="progress"&&y==null?n.removeAttribute(u):y==null||y===n[u]&&(S!="progress"||y)||Dl(n,u,y,v[u],s),u="checked",p!=null&&p!=n[u]&&Dl(n,u,p,v[u],s))}else v===E||a&&n.data==E||(n.data=E);return n}function fd(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){kt.__e(s,t)}}function pd(n,e,t){var i,s,r,o;if(kt.unmount&&kt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||fd(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){kt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&pd(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Ol(i,r=[]))&&(i==n.__e&&r.some(Cr),Cr(s),Cr(i)),t||Cr(n.__e),n.__e=n.__c=n.__=null}function ay(n,e,t){return this.constructor(n,t)}function Vl(n,e){var t,i,s,r;kt.__&&kt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Fl(xt,{children:[n]}),s=[],r=[],dd(e,e.__k,i||Bl,Bl,e.namespaceURI,i?null:e.firstChild?am.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),fm(s,e.__k,r),e.__k.props.children=null}function pm(n){function e(t){var i,s;return this.getChildContext||(i=new Set,(s={})[e.__c]=this,this.getChildContext=function(){return s},this.shouldComponentUpdate=function(r){this.props.value!=r.value&&i.forEach(function(o){o.__g|=4,cd(o)})},this.sub=function(r){i.add(r);var o=r.componentWillUnmount;r.componentWillUnmount=function(){i.delete(r),o&&o.call(r)}}),t.children}return e.__c="__cC"+om++,e.__=n,e.Provider=(e.Consumer=function(t,i){return t.children(i)}).contextType=e,e}kt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw kl=0,n}},im=0,ey=function(n){return n!=null&&n.constructor===xa},Ul.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Rr({},this.state)),typeof n=="function"&&(n=n(Rr({},t),this.props)),n&&(Rr(t,n),this.__v&&(e&&this.__k.push(e),cd(this)))},Ul.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),cd(this))},Ul.prototype.render=xt,Qs=[],kl=0,sm=function(n,e){return n.__v.__b-e.__v.__b},Nl=Symbol(),rm=/(PointerCapture)$|Capture$/i,ud=0,ld={},om=0;var Sm=[{map:"viridis",title:"Viridis"},{map:"cividis",title:"Cividis"},{map:"turbo",title:"Turbo (not colour-blind safe)"},{map:"grey",title:"Grey"}],ly={viridis:"440154470d6048186a482374472d7b4537814240863e49893b528b375b8d33638d2f6b8e2c728e297a8e26828e23898e21918c1f988b1fa08822a78528ae8032b67a3fbc734ec36b5ec96270cf5784d44b98d83eaddc30c2df23d8e219ece51bfde725",cividis:"00224e00285b002e6a0533711a386f273e6e32436d3b496c434e6c4b546c535a6d5a5f6e61656f686a716f70737676767d7c788482798c8878938e789b9476a39a74aba072b4a76fbcae6cc4b468cdbb63d5c25edec958e7d150f0d846f9e03afee838",turbo:"30123b392a734040a24456c7466be34680f64294ff37a8fa28bceb1ccdd818ddc21fe9af32f2984ef97d6dfe628bff4ba4fc3cb9f635cdec34dfdf37eecf3af8be39fdac34fe962bfb7e21f46617eb500edf3f08d02f05be2102a91601920b017a0403",grey:"0a0a0affffff"},cy="08306b2171b56baed6c6dbeff2f0ecfdd0a2f1914ecc4c02702a04",us=256;function Gl(n){return(n.match(/.{6}/g)??[]).map(e=>{let t=Number.parseInt(e,16);return[t>>16,t>>8&255,t&255]})}function uy(n){let e=new Uint8Array(us*4);for(let t=0;t<us;t++){let i=t/(us-1)*(n.length-1),s=Math.min(Math.floor(i),n.length-2),[r,o]=[n[s],n[s+1]],a=l=>r[l]+(o[l]-r[l])*(i-s);e.set([a(0),a(1),a(2),255],t*4)}return e}var mm=new Map;function Mm(n){let e=mm.get(n)??uy(Gl(n));return mm.set(n,e),e}function mo(n){return Mm(ly[n])}function go(){return Mm(cy)}var gm=32,_m=7,vm=Gl("3a40480b0d10e69f0056b4e9f0e4420072b2d55e00ffffffcc79a7999999009e73882255aa4499ddcc7711773388ccee332288cc667744aa99b0724a7f7fffc8e6a0");function er(n){let e=vm.length-_m,t=n<gm?n%e:e+(n-gm)%_m;return vm[t]}function Hl(){let n=new Uint8Array(us*4);for(let e=0;e<us;e++)n.set([...er(e),255],e*4);return n}var xm=127,ym=Gl("7a5195b9a44c4a5f8a7f858db9c0c9"),hy=[47,163,107];function ya(n){return n===0?hy:n<xm?er(n):ym[(n-xm)%ym.length]}function on([n,e,t]){return`rgb(${n}, ${e}, ${t})`}var bm=Gl("2f7fd0c47f001d8f66c04f00b0578c7a5fe0");function Qn(n){return bm[n%bm.length]}var wm=`#version 300 es
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  place = vec2(corner.x, 1.0 - corner.y);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}`,Em=`#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
in vec2 place;
out vec4 color;
uniform int mode;
uniform usampler2D measured;
uniform usampler2D truth;
uniform sampler2D picture;
uniform sampler2D table;
uniform vec2 range;
uniform bool isRelative;
uniform vec3 empty[2];

vec3 lookUp(float from0to1) {
  return texture(table, vec2((clamp(from0to1, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

// Pixels without a value get a hatch, which no colour map has.
vec3 hatch() {
  return empty[int(mod(gl_FragCoord.x + gl_FragCoord.y, 8.0) < 2.0)];
}

uint at(usampler2D image) {
  ivec2 size = textureSize(image, 0);
  return texelFetch(image, min(ivec2(place * vec2(size)), size - 1), 0).r;
}

void main() {
  color.a = 1.0;
  if (mode == 0) {
    color.rgb = texture(picture, place).rgb;
    return;
  }
  uint value = at(measured);
  if (mode == 1) {
    float metres = float(value) * 0.001;
    color.rgb = value == 0u ? hatch() : lookUp((metres - range.x) / max(range.y - range.x, 1e-6));
  } else if (mode == 2) {
    uint exact = at(truth);
    float error = (float(value) - float(exact)) * 0.001;
    if (isRelative) error *= 100.0 / max(float(exact) * 0.001, 1e-3);
    color.rgb = value == 0u || exact == 0u ? hatch() : lookUp(0.5 + 0.5 * error / max(range.y, 1e-9));
  } else if (mode == 3) {
    color.rgb = vec3(float(value) / 255.0);
  } else if (mode == 4) {
    color.rgb = texelFetch(table, ivec2(int(value), 0), 0).rgb;
  } else {
    color.rgb = lookUp(float(value) / 255.0);
  }
}`,wi={picture:0,depth:1,error:2,grey:3,code:4,scale:5};var Rs={measured:0,truth:1,picture:2,table:3},Wl=class{canvas=new OffscreenCanvas(1,1);gl;uniforms;slots=new Map;tables=new Map;reasons=Hl();blank;constructor(e){let t={antialias:!1,alpha:!1,depth:!1,preserveDrawingBuffer:!1},i=this.canvas.getContext("webgl2",t);if(!i)throw new Error("WebGL 2 is not available.");this.gl=i,this.canvas.addEventListener("webglcontextlost",s=>s.preventDefault()),this.canvas.addEventListener("webglcontextrestored",()=>{this.slots.clear(),this.tables.clear(),this.uniforms=this.link(),this.blank=this.integerTexture(),e()}),this.uniforms=this.link(),this.blank=this.integerTexture()}paint(e,t){let i=e.getContext("bitmaprenderer",{alpha:!1});if(!i||!this.bind(t))return!1;let{width:s,height:r}=e;return this.canvas.width!==s&&(this.canvas.width=s),this.canvas.height!==r&&(this.canvas.height=r),this.gl.viewport(0,0,s,r),this.gl.drawArrays(this.gl.TRIANGLES,0,3),i.transferFromImageBitmap(this.canvas.transferToImageBitmap()),!0}keep(e){for(let[t,i]of this.slots)e.some(s=>t.startsWith(`${s}/`))||(this.gl.deleteTexture(i.texture),this.slots.delete(t))}bind(e){let{gl:t,uniforms:i}=this,{kind:s,frame:r,display:o,scales:a}=e,l=r.pictures.get("reference")??r.pictures.get("depth"),c=s==="error"?r.pictures.get("sensor"):s==="depth"?l:r.pictures.get(s);if(!c||s==="error"&&!l)return!1;let u=s==="depth"||s==="sensor"?wi.depth:s==="error"?wi.error:s==="reason"?wi.code:s==="confidence"?wi.scale:s==="color"?wi.picture:wi.grey,[h,d]=s==="error"?[0,a.error]:a.depth;t.uniform1i(i.mode,u),t.uniform2f(i.range,h,d),t.uniform1i(i.isRelative,+(o.errorUnit==="%")),t.uniform3fv(i.empty,e.empty),this.upload(u===wi.picture?Rs.picture:Rs.measured,e.oak,c),this.use(Rs.truth,this.blank),u===wi.error&&l&&this.upload(Rs.truth,e.oak,l),u===wi.picture&&this.use(Rs.measured,this.blank);let f=u===wi.error?go():u===wi.code?this.reasons:mo(o.depthMap);return this.useTable(Rs.table,f),u!==wi.picture&&this.useTable(Rs.picture,f),!0}use(e,t){this.gl.activeTexture(this.gl.TEXTURE0+e),this.gl.bindTexture(this.gl.TEXTURE_2D,t)}upload(e,t,i){let{gl:s}=this,r=`${t}/${i.name}`,o=`${i.width}×${i.height}`,a=this.slots.get(r);if(a||(a={texture:this.integerTexture(),picture:null,size:""},this.slots.set(r,a)),this.use(e,a.texture),a.picture===i)return;let[l,c,u]=i.format==="rgba8"?[s.RGBA8,s.RGBA,s.UNSIGNED_BYTE]:i.format==="u16mm"?[s.R16UI,s.RED_INTEGER,s.UNSIGNED_SHORT]:[s.R8UI,s.RED_INTEGER,s.UNSIGNED_BYTE];a.size===o?s.texSubImage2D(s.TEXTURE_2D,0,0,0,i.width,i.height,c,u,i.data):s.texImage2D(s.TEXTURE_2D,0,l,i.width,i.height,0,c,u,i.data),i.format==="rgba8"&&(s.texParameteri(s.TEXTURE_2D,s.TEXTURE_MIN_FILTER,s.LINEAR),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_MAG_FILTER,s.LINEAR)),a.size=o,a.picture=i}useTable(e,t){let{gl:i}=this,s=this.tables.get(t);if(s)return this.use(e,s);let r=this.texture();this.use(e,r),i.texImage2D(i.TEXTURE_2D,0,i.RGBA8,us,1,0,i.RGBA,i.UNSIGNED_BYTE,t),this.filter(i.NEAREST),this.tables.set(t,r)}texture(){let e=this.gl.createTexture();if(!e)throw new Error("The graphics driver has no more textures.");return e}integerTexture(){let{gl:e}=this,t=this.texture();return this.use(Rs.measured,t),e.texImage2D(e.TEXTURE_2D,0,e.R8UI,1,1,0,e.RED_INTEGER,e.UNSIGNED_BYTE,new Uint8Array(1)),this.filter(e.NEAREST),t}filter(e){let{gl:t}=this;t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MIN_FILTER,e),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MAG_FILTER,e),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_S,t.CLAMP_TO_EDGE),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_T,t.CLAMP_TO_EDGE)}link(){let{gl:e}=this,t=e.createProgram();for(let[s,r]of[[e.VERTEX_SHADER,wm],[e.FRAGMENT_SHADER,Em]]){let o=e.createShader(s);o&&(e.shaderSource(o,r),e.compileShader(o),e.attachShader(t,o))}if(e.linkProgram(t),!e.getProgramParameter(t,e.LINK_STATUS)&&!e.isContextLost())throw new Error(e.getProgramInfoLog(t)??"The shaders do not link.");e.useProgram(t),e.pixelStorei(e.UNPACK_ALIGNMENT,1);let i=s=>e.getUniformLocation(t,s);for(let[s,r]of Object.entries(Rs))e.uniform1i(i(s),r);return{mode:i("mode"),measured:i("measured"),truth:i("truth"),picture:i("picture"),table:i("table"),range:i("range"),isRelative:i("isRelative"),empty:i("empty")}}};var ba=class extends Error{},Tm=24;function Am(n,e){let t=new Uint8Array(e),i=0,s=0,r=o=>{let a=o===15?255:0;for(;a===255;)a=n[i++]??0,o+=a;return o};for(;i<n.length;){let o=n[i++],a=r(o>>4);if(i+a>n.length||s+a>e)throw new ba("The literals exceed the block.");if(a<Tm)for(let u=0;u<a;u++)t[s+u]=n[i+u];else t.set(n.subarray(i,i+a),s);if(i+=a,s+=a,i>=n.length)break;let l=n[i]|(n[i+1]??0)<<8;i+=2;let c=r(o&15)+4;if(l===0||l>s||s+c>e)throw new ba("A copy exceeds the output.");dy(t,s,l,c),s+=c}if(s!==e)throw new ba(`The block has ${s} bytes instead of ${e}.`);return t}function dy(n,e,t,i){if(i<Tm){for(let r=0;r<i;r++)n[e+r]=n[e+r-t];return}let s=Math.min(t,i);for(n.copyWithin(e,e-t,e-t+s);s<i;){let r=Math.min(s,i-s);n.copyWithin(e+s,e,e+r),s+=r}}var fy={rgba8:4,u16mm:2,u8:1};function Cm(n){let e=new DataView(n).getUint32(0,!0),t=new TextDecoder().decode(new Uint8Array(n,4,e));return[JSON.parse(t),4+e]}function Rm(n,e){let[t,i]=Cm(n),s=new Map;for(let r of t.images){let{name:o,width:a,height:l,format:c}=r;if(r.unchanged){let f=e(t.oak)?.get(o);f&&s.set(o,f);continue}let u=new Uint8Array(n,i+r.offset,r.length),h=Am(u,a*l*fy[c]),d=c==="u16mm"?new Uint16Array(h.buffer):h;s.set(o,{name:o,width:a,height:l,format:c,data:d})}return{header:t,pictures:s}}function Xl(n){let[e,t]=Cm(n),{vertices:i,triangles:s}=e,r=Math.ceil(t/4)*4,o=a=>{let l=r;return r+=a,l};return{header:e,positions:new Float32Array(n,o(i*12),i*3),colors:new Uint8Array(n,o(i*4),i*4),indices:new Uint32Array(n,o(s*12),s*3),objects:new Uint32Array(n,o(s*4),s)}}var vo=class extends Error{constructor(t,i){super(t.error);this.failure=t;this.status=i}failure;status;get findings(){return this.failure.findings??[]}};async function Sa(n,e){let t=await fetch(n,e);if(t.ok)return t;let i=await t.text();throw new vo(py(i,t),t.status)}function py(n,e){try{let t=JSON.parse(n);if(typeof t.error=="string")return t}catch{}return{error:n.trim()||`The server answered ${e.status} ${e.statusText}.`}}async function _o(n,e){return await(await Sa(n,e)).json()}function ql(n,e){let t={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(n)};return e&&(t.signal=e),t}var hn={catalog:()=>_o("/api/catalog"),scene:n=>_o(`/api/scenes/${encodeURIComponent(n)}`),async sceneMesh(n,e){let t=await Sa(`/api/scenes/${encodeURIComponent(n)}/mesh?triangles=${e}`);return Xl(await t.arrayBuffer())},async body(n){let e=await Sa(`/api/models/${encodeURIComponent(n)}/body`);return Xl(await e.arrayBuffer())},openScene:n=>_o(`/api/scenes?name=${encodeURIComponent(n.name)}`,{method:"POST",body:n}),openCalibration:n=>_o(`/api/calibrations?name=${encodeURIComponent(n.name)}`,{method:"POST",body:n}),accuracy:(n,e)=>_o("/api/accuracy",ql(n,e)),coverage:(n,e)=>_o("/api/coverage",ql(n,e)),async surface(n,e){let t=await Sa("/api/coverage/surface",ql(n,e));return Xl(await t.arrayBuffer())},async export(n){let e=await Sa("/api/export",ql(n)),t=e.headers.get("Content-Disposition")??"",i=/filename="([^"]+)"/.exec(t)?.[1]??`oaktwin-${n.what}`,s=JSON.parse(e.headers.get("X-Findings")??"[]");return{name:i,file:await e.blob(),findings:s}}};var Pr,_n,md,Pm,gd=Object.is,Yl=0,Bm=[],_d=[],Sn=kt,Im=Sn.__b,Lm=Sn.__r,Dm=Sn.diffed,Nm=Sn.__c,Fm=Sn.unmount,Um=Sn.__;function wa(n,e){Sn.__h&&Sn.__h(_n,n,Yl||e),Yl=0;var t=_n.__H||(_n.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Pt(n){return Yl=1,my(Vm,n)}function my(n,e,t){var i=wa(Pr++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Vm(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);gd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=_n,!_n.__f)){_n.__f=!0;var s=_n.shouldComponentUpdate;_n.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(d){d.__N&&(c=!0,gd(d.__[0],d.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function Gt(n,e){var t=wa(Pr++,3);!Sn.__s&&xd(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,_n.__H.__h.push(t))}function hs(n,e){var t=wa(Pr++,4);!Sn.__s&&xd(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,_n.__h.push(t))}function Tt(n){return Yl=5,Ir(function(){return{current:n}},[])}function Ir(n,e){var t=wa(Pr++,7);return xd(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function zm(n){var e=_n.context[n.__c],t=wa(Pr++,9);return t.c=n,e?(t.__==null&&(t.__=!0,e.sub(_n)),e.props.value):n.__}function gy(){var n;do{for(;n=_d.shift();)try{Ma(n)}catch(t){Sn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Bm.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ma),e.__h.some(vd),e.__h=[]}catch(t){e.__h=[],Sn.__e(t,n.__v)}}}while(_d.length)}Sn.__b=function(n){_n=null,Im&&Im(n)},Sn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Um&&Um(n,e)},Sn.__r=function(n){Lm&&Lm(n),Pr=0;var e=(_n=n.__c).__H;e&&(md==_n?_n.__h=[]:(e.__h.some(Ma),e.__h.some(vd),Pr=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),md=_n},Sn.diffed=function(n){Dm&&Dm(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&km(Bm.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),md=_n=null},Sn.__c=function(n,e){e.some(function(t){try{t.__h.some(Ma),t.__h=t.__h.filter(function(i){return!i.__||vd(i)})}catch(i){t.__h=[function(){throw i}]}}),Nm&&Nm(n,e)},Sn.unmount=function(n){Fm&&Fm(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,km(_d.push(s))}else Ma(s)}catch(r){e=r}}),i.__H=void 0,e&&Sn.__e(e,i.__v))};var Om=typeof requestAnimationFrame=="function";function _y(n){var e,t=function(){clearTimeout(i),Om&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Om&&(e=requestAnimationFrame(t))}function km(n){n!=1&&Pm==Sn.requestAnimationFrame||((Pm=Sn.requestAnimationFrame)||_y)(gy)}function Ma(n){var e=_n,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),_n=e}function vd(n){var e=_n;n.__c=n.__(),_n=e}function xd(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!gd(t,n[i])})}function Vm(n,e){return typeof e=="function"?e(n):e}var Bt=class{constructor(e){this.value=e}value;listeners=new Set;get(){return this.value}set(e){if(!Object.is(e,this.value)){this.value=e;for(let t of[...this.listeners])t()}}update(e){this.set(e(this.value))}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}};function Ae(n){let[e,t]=Pt(()=>n.get());return Gt(()=>{let i=()=>t(()=>n.get());return i(),n.subscribe(i)},[n]),e}function Ps(n,e){let[,t]=Pt(0),i=e(n.get());return Gt(()=>{let s=i,r=()=>{let o=e(n.get());Object.is(o,s)||(s=o,t(a=>a+1))};return r(),n.subscribe(r)}),i}function yd({model:n,calibration:e,populationSeed:t,sensor:i,lens:s,engine:r,preset:o,extendedDisparity:a,drift:l}){return JSON.stringify([n,e,t,i,s,r,o,a,l])}var $l=class extends Bt{constructor(){super(new Map)}learn(e,t){let i=this.get().get(yd(e))??{},s=Object.entries(t).filter(([r,o])=>!(r in e.parameters)&&i[r]!==o);s.length&&this.set(new Map(this.get()).set(yd(e),{...i,...Object.fromEntries(s)}))}of(e,t){return this.get().get(yd(e))?.[t.name]??t.default}};var Gm=[200,500,1e3,2e3],Zl=class{constructor(e){this.handlers=e}handlers;socket=null;attempts=0;pictures=new Map;connect(){let e=location.protocol==="https:"?"wss:":"ws:",t=new WebSocket(`${e}//${location.host}/api/live`);t.binaryType="arraybuffer",t.onopen=()=>{this.socket=t,this.attempts=0,this.pictures.clear(),this.handlers.onConnection("open")},t.onmessage=({data:i})=>{typeof i=="string"?this.handlers.onMessage(JSON.parse(i)):this.handlers.onFrame(this.decode(i))},t.onclose=()=>{this.socket=null,this.handlers.onConnection("lost");let i=Gm[Math.min(this.attempts++,Gm.length-1)];setTimeout(()=>this.connect(),i)}}decode(e){let t=Rm(e,s=>this.pictures.get(s)),{oak:i}=t.header;return this.pictures.set(i,new Map([...this.pictures.get(i)??[],...t.pictures])),t}send(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(e)),!0)}};var Kl=class{constructor(e){this.send=e}send;waiting=new Map;sent=new Map;lastId=0;request(e){this.waiting.set(e.oak,e),this.flush(e.oak)}settle(e,t){let i=this.sent.get(e),s=i?.get(t)??null;for(let r of[...i?.keys()??[]])r<=t&&i?.delete(r);return this.flush(e),s}forget(e){this.waiting.delete(e),this.sent.delete(e)}reset(){this.waiting.clear(),this.sent.clear()}get isIdle(){return this.waiting.size===0&&[...this.sent.values()].every(e=>e.size===0)}flush(e){let t=this.waiting.get(e),i=this.sent.get(e)??new Map;if(!t||i.size>=2)return;let s=++this.lastId;this.send({type:"frame",id:s,...t})&&(this.waiting.delete(e),i.set(s,t),this.sent.set(e,i))}};var Ui=[{kind:"color",title:"Colour",help:"The colour image in the view of the depth sensor",images:["color"]},{kind:"depth",title:"Exact depth",help:"The true distance along the optical axis",images:["depth","reference"]},{kind:"sensor",title:"Sensor depth",help:"The depth that the OAK measures",images:["sensor"]},{kind:"error",title:"Error",help:"Measured minus true depth",images:["sensor","depth","reference"]},{kind:"confidence",title:"Confidence",help:"How sure the matcher is of each pixel; not made by every engine",images:["confidence"]},{kind:"left",title:"Left",help:"The rectified infrared image of the left camera",images:["left"]},{kind:"right",title:"Right",help:"The rectified infrared image of the right camera",images:["right"]},{kind:"reason",title:"Reasons",help:"Why a pixel has no value",images:["reason"]}],yo=[{size:"small",title:"640 × 400",limit:[640,400]},{size:"large",title:"1280 × 800",limit:[1280,800]},{size:"native",title:"Native",limit:null}],xo={theme:"auto",panels:["color","depth","sensor","error"],wipe:null,wipeAt:.5,depthMap:"viridis",depthRange:null,errorRange:null,errorUnit:"mm",fullSize:"large",showCameras:!0,showRanges:!0,showGrid:!0,showScene:!0,showRoof:!1,cloud:"none",cloudColor:"error",toleranceMm:null,paintsCoverage:!0,split:.46,showLeft:!0,showRight:!0},Hm="oaktwin-studio-display";function Wm(){try{return bd(JSON.parse(localStorage.getItem(Hm)??"{}"))}catch{return xo}}function Xm(n){try{localStorage.setItem(Hm,JSON.stringify(n))}catch{}}function bd(n){let e={...xo};if(typeof n!="object"||n===null)return e;for(let[t,i]of Object.entries(n))xy(t,i)&&Object.assign(e,{[t]:i});return e}var vy={theme:["auto","light","dark"],depthMap:["viridis","cividis","turbo","grey"],errorUnit:["mm","%"],fullSize:["small","large","native"],cloud:["none","truth","measurement","both"],cloudColor:["depth","error","reason","oak"]};function xy(n,e){let t=i=>Ui.some(s=>s.kind===i);switch(n){case"panels":return Array.isArray(e)&&e.every(t);case"wipe":return e===null||t(e?.left)&&t(e?.right);case"depthRange":return e===null||Array.isArray(e)&&e.length===2&&e.every(Number.isFinite);case"errorRange":case"toleranceMm":return e===null||Number.isFinite(e)&&e>0;case"wipeAt":case"split":return Number.isFinite(e)&&e>=0&&e<=1;default:return vy[n]?.includes(e)??(n in xo&&typeof e==typeof xo[n])}}function qm(n){let e=new Map;for(let i of n)for(let s=i.lastIndexOf("/");s>0;s=i.lastIndexOf("/",s-1)){let r=i.slice(0,s);e.set(r,(e.get(r)??0)+1)}let t=[...e].filter(([,i])=>i>1).map(([i])=>i);return[...new Set([...n,...t])].sort()}var tr=[0,0,1,1],Ea=6;function _i(n,e){return n.models.find(t=>t.name===e)}function ui(n,e){return _i(n,e.model)?.depthSensors.find(t=>t.id===e.sensor)}function Sd(n,e){return n.engines.find(t=>t.name===e.engine)}function Jl(n,e){let t=n.depthSensors[0];return{model:n.name,calibration:null,pose:e,sensor:t?.id??"",lens:"pinhole",engine:t?.engines[0]??"",preset:null,filters:null,parameters:{},extendedDisparity:!1,seed:0,deviceSeed:null,populationSeed:null,drift:{},projector:n.hasProjector?1:0,ambient:1}}function Ql(n,e){let{pose:t,seed:i,deviceSeed:s,populationSeed:r,ambient:o}=n,a={...Jl(e,t),seed:i,deviceSeed:s,populationSeed:r,ambient:o},l=e.depthSensors.find(({id:f})=>f===n.sensor);if(!l)return a;let c=l.kind==="stereo"?n.drift:{},u=l.engines.includes(n.engine)?n.engine:a.engine,h=n.preset!==null&&l.presets.includes(n.preset)?n.preset:null,d=u===n.engine?n.parameters:{};return{...a,sensor:l.id,engine:u,preset:h,parameters:d,drift:c,filters:n.filters,extendedDisparity:n.extendedDisparity}}function yy(n){let e=1;for(;n.some(t=>t.key===`oak${e}`);)e++;return`oak${e}`}function Ym(n,e,t){let i=_i(n,n.model)??n.models[0],s=i?[{key:"oak1",isHidden:!1,state:Jl(i,t)}]:[];return{scene:e,oaks:s,selected:"oak1",arePosesLinked:!0,region:tr,target:null}}function Fn(n){return n.oaks.find(e=>e.key===n.selected)}function nr(n,e,t){let i=n.oaks.find(o=>o.key===e);if(!i)return n;let s=t(i.state),r=n.oaks.map(o=>o.key===e?{...o,state:s}:n.arePosesLinked&&s.pose!==i.state.pose?{...o,state:{...o.state,pose:s.pose}}:o);return{...n,oaks:r}}function Md(n,e){if(n.oaks.length>=Ea)return n;let t={key:yy(n.oaks),isHidden:!1,state:e},i=n.oaks.findIndex(({key:s})=>s===n.selected)+1;return{...n,oaks:n.oaks.toSpliced(i,0,t),selected:t.key}}function $m(n,e){if(n.oaks.length<=1)return n;let t=n.oaks.findIndex(r=>r.key===e),i=n.oaks.filter(r=>r.key!==e),s=i[Math.min(t,i.length-1)];return{...n,oaks:i,selected:n.selected===e?s?.key??"":n.selected}}var by=150,Zm=[[640,400],[480,300],[320,200],[240,150]],Sy=3,My=50,wy=20;function wd([n,e],t){let i=t?Math.min(t[0]/n,t[1]/e):1;return i>=1?null:[Math.round(n*i),Math.round(e*i)]}function Km(n){let{wipe:e,cloud:t,cloudColor:i}=n,s=e?[e.left,e.right]:n.panels,r=new Set(["depth","reference","sensor"]);for(let o of Ui)if(s.includes(o.kind))for(let a of o.images)r.add(a);return t!=="none"&&i==="reason"&&r.add("reason"),[...r].sort()}var ec=class{constructor(e,t,i){this.studio=e;this.probes=t;this.defaults=i;this.live=new Zl({onConnection:s=>this.connected(s==="open"),onFrame:s=>this.show(s),onMessage:s=>this.read(s)}),this.scheduler=new Kl(s=>this.live.send(s)),t.connect(s=>this.live.send(s)),e.document.subscribe(()=>this.follow()),e.display.subscribe(()=>this.follow()),e.scene.subscribe(()=>this.follow()),this.live.connect()}studio;probes;defaults;received=0;live;scheduler;requested=new Map;moving=new WeakSet;previews=new WeakSet;coarseness=0;limits=new Map;timer=0;wasLost=!1;get isIdle(){return this.timer===0&&this.scheduler.isIdle&&this.probes.isIdle}connected(e){let{studio:t}=this;if(t.connection.set(e?"open":"lost"),this.scheduler.reset(),this.probes.reset(),this.requested.clear(),!e){this.wasLost=!0;return}this.wasLost&&t.restart().then(()=>t.notify("note","Connected to the server again."),i=>t.report("Reconnecting",i)),this.wasLost=!1,this.follow()}follow(){let{document:e,scene:t,connection:i}=this.studio,{oaks:s,region:r,scene:o}=e.get();if(i.get()!=="open"||t.get()?.id!==o)return;this.forgetRemoved(s);let{fullSize:a}=this.studio.display.get(),l=Km(this.studio.display.get());for(let c of s){if(c.isHidden||!this.studio.hasDepth(c.state))continue;let u=[o,c.state,...r,a,...l],h=this.requested.get(c.key);if(h&&h.length===u.length&&h.every((g,y)=>g===u[y]))continue;this.requested.set(c.key,u);let d=h?.[1]?.pose!==c.state.pose,f=this.request(c,Zm[d?this.coarseness:0]??null,l,d?Sy:1);d&&this.moving.add(f),this.rest()}}rest(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>{this.timer=0;let{document:e,display:t}=this.studio,i=this.limitAtRest(),s=Km(t.get());for(let r of e.get().oaks)!r.isHidden&&this.studio.hasDepth(r.state)&&this.limits.get(r.key)!==jl(i,1)&&this.request(r,i,s,1)},by)}limitAtRest(){let{fullSize:e}=this.studio.display.get();return yo.find(({size:t})=>t===e)?.limit??null}request(e,t,i,s){let{scene:r,region:o}=this.studio.document.get(),a=ui(this.studio.catalog.get(),e.state)?.resolution,l=a?wd(a,t):null;this.limits.set(e.key,jl(t,s));let c={oak:e.key,scene:r,state:e.state,size:l,images:i,region:o,colorStep:s};return jl(t,s)!==jl(this.limitAtRest(),1)&&this.previews.add(c),this.scheduler.request(c),c}forgetRemoved(e){let t=s=>e.some(r=>r.key===s&&!r.isHidden),{frames:i}=this.studio;for(let s of this.requested.keys())t(s)||(this.requested.delete(s),this.scheduler.forget(s));[...i.get().keys()].some(s=>!t(s))&&i.set(new Map([...i.get()].filter(([s])=>t(s))))}show(e){let{id:t,oak:i}=e.header,s=this.scheduler.settle(i,t);s&&(this.received++,this.moving.has(s)&&this.adapt(e.header.milliseconds),this.defaults.learn(s.state,e.header.parameters),this.accept(i,s,e),this.probes.refresh(i))}adapt(e){e>My?this.coarseness=Math.min(this.coarseness+1,Zm.length-1):e<wy&&(this.coarseness=Math.max(this.coarseness-1,0))}accept(e,t,i){let{frames:s,rejections:r}=this.studio;r.get().has(e)&&r.set(Ey(r.get(),e)),s.set(new Map(s.get()).set(e,{...i,state:t.state,scene:t.scene,requested:t.images,isPreview:this.previews.has(t)}))}read(e){e.type==="probe"?this.probes.show(e):this.reject(e)}reject(e){this.probes.reject(e.id,e.oak)||this.scheduler.settle(e.oak,e.id)&&this.studio.rejections.set(new Map(this.studio.rejections.get()).set(e.oak,e))}};function jl(n,e){return`${n?.join()??"native"}/${e}`}function Ey(n,e){return new Map([...n].filter(([t])=>t!==e))}var tc=class{constructor(e){this.studio=e;e.hover.subscribe(()=>this.follow())}studio;send=()=>!1;inFlight=null;waiting=null;lastId=1e9;connect(e){this.send=e}get isIdle(){return this.inFlight===null&&this.waiting===null}reset(){this.inFlight=null,this.waiting=null}refresh(e){this.studio.hover.get()?.oak===e&&this.follow()}show(e){e.id===this.inFlight?.id&&(this.inFlight=null,this.studio.hover.get()?.oak===e.oak&&this.studio.probe.set(e),this.flush())}reject(e,t){return e!==this.inFlight?.id||t!==this.inFlight.oak?!1:(this.inFlight=null,this.studio.probe.set(null),this.flush(),!0)}follow(){let e=this.studio.hover.get();if(!e){this.waiting=null,this.studio.probe.set(null);return}this.waiting={oak:e.oak,x:e.x,y:e.y},this.flush()}flush(){if(this.inFlight||!this.waiting)return;let e={type:"probe",id:++this.lastId,...this.waiting};this.send(e)&&(this.waiting=null,this.inFlight=e)}};var Ty=1e3,Ay=200,nc=class extends Bt{past=[];future=[];lastTag="";lastTime=0;commit(e,t){let i=this.get(),s=t(i);if(Object.is(i,s))return;let r=performance.now();e===this.lastTag&&r-this.lastTime<Ty||(this.past.push(i),this.past.length>Ay&&this.past.shift()),this.lastTag=e,this.lastTime=r,this.future=[],this.set(s)}reset(e){this.past=[],this.future=[],this.lastTag="",this.set(e)}undo(){this.step(this.past,this.future)}redo(){this.step(this.future,this.past)}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}step(e,t){let i=e.pop();i!==void 0&&(t.push(this.get()),this.lastTag="",this.set(i))}};var Jm=["theme","split","showLeft","showRight","wipeAt"],Ed="v1.";function Qm({document:n,display:e}){let t=Object.entries(e).filter(([r,o])=>!Jm.includes(r)&&o!==xo[r]),i=JSON.stringify({document:n,display:Object.fromEntries(t)}),s=String.fromCharCode(...new TextEncoder().encode(i));return`#${Ed}${btoa(s).replaceAll("+","-").replaceAll("/","_").replaceAll("=","")}`}function Td(n,e){let t=n.replace(/^#/,"");if(!t.startsWith(Ed))return null;try{let i=atob(t.slice(Ed.length).replaceAll("-","+").replaceAll("_","/")),s=new TextDecoder().decode(Uint8Array.from(i,l=>l.charCodeAt(0))),r=JSON.parse(s),o=Cy(r.document);if(!o)return null;let a=bd(r.display);for(let l of Jm)Object.assign(a,{[l]:e[l]});return{document:o,display:a}}catch{return null}}function bo(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function Ta(n,e){return Array.isArray(n)&&n.length===e&&n.every(Number.isFinite)?n:null}function Cy(n){if(!bo(n)||typeof n.scene!="string"||!Array.isArray(n.oaks))return null;let e=n.oaks.slice(0,Ea).map(Py).filter(i=>i!==null),t=e[0];return!t||new Set(e.map(({key:i})=>i)).size!==e.length?null:{scene:n.scene,oaks:e,selected:e.find(({key:i})=>i===n.selected)?.key??t.key,arePosesLinked:n.arePosesLinked!==!1,region:Ta(n.region,4)??tr,target:Ry(n.target)}}function Ry(n){if(!bo(n))return null;if(typeof n.object=="string")return{object:n.object};let[e,t]=[Ta(n.minimum,3),Ta(n.maximum,3)];return e&&t?{minimum:e,maximum:t}:null}function Py(n){if(!bo(n)||typeof n.key!="string")return null;let e=Iy(n.state);return e&&{key:n.key,isHidden:n.isHidden===!0,state:e}}function Iy(n){if(!bo(n)||!bo(n.pose)||typeof n.model!="string")return null;let e=Ta(n.pose.position,3),t=Ta(n.pose.quaternion,4);if(!e||!t)return null;let i=o=>typeof o=="string"?o:null,s=(o,a)=>Number.isFinite(o)?o:a,r=o=>{let a=bo(o)?Object.entries(o).filter(([,l])=>i(l)!==null):[];return Object.fromEntries(a)};return{model:n.model,calibration:i(n.calibration),pose:{position:e,quaternion:t},sensor:i(n.sensor)??"",lens:n.lens==="fisheye"?"fisheye":"pinhole",engine:i(n.engine)??"",preset:i(n.preset),filters:Array.isArray(n.filters)?n.filters.filter(o=>typeof o=="string"):null,parameters:r(n.parameters),extendedDisparity:n.extendedDisparity===!0,seed:s(n.seed,0),deviceSeed:Number.isFinite(n.deviceSeed)?n.deviceSeed:null,populationSeed:Number.isFinite(n.populationSeed)?n.populationSeed:null,drift:r(n.drift),projector:s(n.projector,1),ambient:s(n.ambient,1)}}var Ly=400,Dy=4,ic=class{document;display;catalog;scene=new Bt(null);frames=new Bt(new Map);rejections=new Bt(new Map);connection=new Bt("connecting");hover=new Bt(null);probe=new Bt(null);notices=new Bt([]);calibrations=new Bt(new Map);lastNotice=0;loading="";constructor(e,t){this.catalog=new Bt(e);let i=Wm(),s=Td(location.hash,i);this.display=new Bt(s?.display??i),this.document=new nc(s?.document??Ym(e,t.id,t.pose)),this.document.get().scene===t.id&&this.scene.set(t),this.followAddress(),this.display.subscribe(()=>Xm(this.display.get())),this.document.subscribe(()=>{this.followScene()}),this.followScene()}change(e,t){let{selected:i}=this.document.get();this.document.commit(`${i}/${e}`,s=>nr(s,i,t))}show(e){this.display.update(t=>({...t,...e}))}notify(e,t,i=[]){let s={id:++this.lastNotice,level:e,text:t,findings:i};this.notices.update(r=>[...r.filter(o=>o.text!==t),s].slice(-Dy))}report(e,t){let i=t instanceof Error?t.message:String(t);this.notify("error",`${e}: ${i}`,t instanceof vo?t.findings:[])}dismiss(e){this.notices.update(t=>t.filter(i=>i.id!==e))}link(){let e=Qm({document:this.document.get(),display:this.display.get()});return`${location.origin}${location.pathname}${e}`}async restart(){let{version:e}=this.catalog.get();this.catalog.set(await hn.catalog()),this.catalog.get().version!==e&&this.notify("warning","The server has another version now. Reload the page."),this.loading="",this.scene.set(null),await this.followScene()}async followScene(){let{scene:e}=this.document.get();if(!(e===this.scene.get()?.id||e===this.loading)){this.loading=e;try{let t=await hn.scene(e);this.document.get().scene===e&&this.scene.set(t)}catch(t){this.document.get().scene===e&&await this.replaceScene(t)}finally{this.loading===e&&(this.loading="")}}}async replaceScene(e){let t=this.catalog.get().scene;if(!(e instanceof vo)||this.document.get().scene===t){this.connection.get()==="open"&&this.report("The scene cannot be loaded",e);return}let{oaks:i}=this.document.get();this.notify("warning","The server does not have the scene of this state; drop its file onto the page again.");let s=await hn.scene(t),r=i.map(o=>({...o,state:{...o.state,pose:s.pose}}));this.document.reset({...this.document.get(),scene:t,oaks:r,target:null}),this.scene.set(s)}followAddress(){let e=0,t=location.hash,i=()=>{t=new URL(this.link()).hash,history.replaceState(null,"",t)},s=()=>{clearTimeout(e),e=window.setTimeout(i,Ly)};this.document.subscribe(s),this.display.subscribe(s),addEventListener("hashchange",()=>{let r=location.hash===t?null:Td(location.hash,this.display.get());r&&(this.display.set(r.display),this.document.commit("link",()=>r.document))})}hasDepth(e){return(_i(this.catalog.get(),e.model)?.depthSensors.length??0)>0}};var Ad=pm(null);function Ve(){let n=zm(Ad);if(!n)throw new Error("There is no studio above this component.");return n}function Aa(n){if(n==null||!Number.isFinite(n))return"–";let e=Math.abs(n);return e<.001?`${(n*1e3).toFixed(3)} mm`:e<.1?`${(n*1e3).toFixed(1)} mm`:`${n.toFixed(3)} m`}function ir(n){let e=rr(n,!0);return e==="–"?"–":`${e} mm`}function sr(n){return n==null||!Number.isFinite(n)?"–":(n*100).toFixed(1)}function rr(n,e=!1){if(n==null||!Number.isFinite(n))return"–";let t=Math.abs(n*1e3).toFixed(1);return Number(t)===0?t:`${n<0?"−":e?"+":""}${t}`}function jm(n){let e=rr(n);return e==="–"?"–":`${e} mm`}function Lr(n){return n==null||!Number.isFinite(n)?"–":`${(n*100).toFixed(1)} %`}function vn(n){let e=n.replace(/[_-]+/g," ").replace(/([a-z0-9])([A-Z])/g,(t,i,s)=>`${i} ${s.toLowerCase()}`);return e.charAt(0).toUpperCase()+e.slice(1)}function eg(n){return n.replaceAll("-","‑")}function Cd(n){return n<1e6?`${(n/1e3).toFixed(0)} kB`:`${(n/1e6).toFixed(0)} MB`}function Rd(n){if(!(n>0))return 0;let e=10**Math.floor(Math.log10(n)),t=[1,2,5,10].find(i=>n<=i*e*1.0001)??10;return Number((t*e).toPrecision(3))}async function sc(n,e){for(let t of e){let i=n.catalog.get().maxUploadBytes;if(t.size>i){n.notify("error",`${t.name} has ${Cd(t.size)}, more than the ${Cd(i)} that can be opened here; give it on the command line: oaktwin studio ${t.name}`);continue}try{Ny(t)?Uy(n,await hn.openCalibration(t)):Fy(n,await hn.openScene(t))}catch(s){n.report("Not opened",s)}}}function Ny(n){return n.name.toLowerCase().endsWith(".json")}function Fy(n,e){n.document.commit("scene",i=>({...i,scene:e.id,oaks:i.oaks.map(s=>({...s,state:{...s.state,pose:e.pose}})),target:null}));let t=e.findings.some(({level:i})=>i!=="note")?"warning":"note";n.notify(t,`${e.name}: ${e.triangles.toLocaleString("en")} triangles.`,e.findings)}function Uy(n,e){if(n.calibrations.set(new Map(n.calibrations.get()).set(e.id,e)),e.findings.some(({level:i})=>i==="error")){n.notify("error",`${e.name} has errors and is not used.`,e.findings);return}let t=e.model===null?void 0:_i(n.catalog.get(),e.model);n.document.commit("calibration",i=>nr(i,i.selected,s=>({...t&&t.name!==s.model?Ql(s,t):s,calibration:e.id,populationSeed:null}))),n.notify("note",`${e.name} calibrates the selected OAK${t?`, an ${t.name}`:""}.`,e.findings)}var Oy=Symbol.for("pv"),ky=0;function _(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Oy,__v:--ky,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),kt.vnode&&kt.vnode(c),c}var By={add:"M8 3v10M3 8h10",close:"M4 4l8 8M12 4l-8 8",copy:"M6 6h7v7H6zM3 10V3h7",down:"M8 3v10M4 9l4 4 4-4",up:"M8 13V3M4 7l4-4 4 4",undo:"M6 3L3 6l3 3M3 6h6a4 4 0 010 8H6",redo:"M10 3l3 3-3 3M13 6H7a4 4 0 000 8h3",eye:"M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8zM8 6a2 2 0 100 4 2 2 0 000-4z",hidden:"M2 2l12 12M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8z",theme:"M8 2.5a5.5 5.5 0 100 11zM8 2.5a5.5 5.5 0 010 11",help:"M6 6a2 2 0 113 1.7c-.7.4-1 .8-1 1.8M8 12v.5M8 1.5a6.5 6.5 0 100 13 6.5 6.5 0 000-13z",open:"M2 13V3h4l1.5 2H14v8z",share:"M7 9l2-2M6.5 5.5L8 4a2.8 2.8 0 014 4l-1.5 1.5M9.5 10.5L8 12a2.8 2.8 0 01-4-4l1.5-1.5",download:"M8 2v8M4.5 7L8 10.5 11.5 7M2.5 13.5h11",reset:"M3 8a5 5 0 105-5H5M7 1L5 3l2 2",left:"M2 3h12v10H2zM6 3v10",right:"M2 3h12v10H2zM10 3v10",link:"M6 4H4a3 3 0 000 8h2M10 4h2a3 3 0 010 8h-2M5 8h6",move:"M8 1.5v13M1.5 8h13M6 3.5l2-2 2 2M6 12.5l2 2 2-2M3.5 6l-2 2 2 2M12.5 6l2 2-2 2",turn:"M13 5.5A5.5 5.5 0 108 13.5M13 2v3.5H9.5",home:"M2.5 8L8 3l5.5 5M4 7v6h8V7",camera:"M2 5h3l1-1.5h4L11 5h3v8H2zM8 7a2 2 0 100 4 2 2 0 000-4z",warning:"M8 2L1.5 13.5h13zM8 6v4M8 11.5v.6",dice:"M3 3h10v10H3zM6 6h.1M10 10h.1M8 8h.1M10 6h.1M6 10h.1"};function rc({name:n}){return _("svg",{class:"icon",viewBox:"0 0 16 16","aria-hidden":"true",children:_("path",{d:By[n]})})}function Ge({icon:n,label:e,onClick:t,isNamed:i=!n,isOn:s,isDisabled:r=!1,class:o="",tip:a,testId:l}){return _("button",{type:"button",class:`button ${i?"":"square"} ${o}`,"aria-label":i?void 0:e,"aria-pressed":s,disabled:r,"data-tip":a??(i?void 0:e),"data-testid":l,onClick:t,children:[n&&_(rc,{name:n}),i&&_("span",{children:e})]})}function hi({label:n,value:e,options:t,onChange:i,isLabelled:s=!0,testId:r}){return _("label",{class:"field",children:[_("span",{class:s?"name":"sr-only",children:n}),_("select",{value:e,"data-testid":r,onChange:o=>i(o.currentTarget.value),children:t.map(o=>_("option",{value:o.value,selected:o.value===e,children:o.title},o.value))})]})}function Oi({label:n,isOn:e,onChange:t,tip:i,isDisabled:s=!1}){return _("label",{class:"check","data-tip":i,children:[_("input",{type:"checkbox",checked:e,disabled:s,onChange:r=>t(r.currentTarget.checked)}),_("span",{children:n})]})}function oc({label:n,text:e,onText:t,onStep:i,problem:s,isLabelled:r=!0,tip:o,unit:a,testId:l}){let[c,u]=Pt(null),[h,d]=Pt(null),f=Tt(null),g=h??s;Gt(()=>{document.activeElement!==f.current&&(u(null),d(null))},[e]);let y=()=>{u(null),d(null)};return _("label",{class:"field","data-tip":o,children:[_("span",{class:r?"name":"sr-only",children:n}),_("span",{class:"with-unit",children:[_("input",{ref:f,type:"text",inputMode:i?"decimal":"text",spellcheck:!1,autocomplete:"off",value:c??e,"aria-invalid":g?"true":void 0,"data-testid":l,onInput:m=>{u(m.currentTarget.value),d(t(m.currentTarget.value))},onBlur:y,onKeyDown:m=>{m.key==="Enter"&&y(),!(!i||m.key!=="ArrowUp"&&m.key!=="ArrowDown")&&(m.preventDefault(),y(),i((m.key==="ArrowUp"?1:-1)*(m.shiftKey?.1:1)))}}),a&&_("span",{class:"unit",children:a})]}),g&&_("span",{class:"problem",role:"alert",children:g})]})}function Mn({value:n,onChange:e,step:t,digits:i,minimum:s=-1e6,maximum:r=1e6,...o}){let a=c=>{let u=Number(c.trim().replace(",","."));return c.trim()===""||!Number.isFinite(u)?"Enter a number.":u<s?`Enter at least ${s}.`:u>r?`Enter at most ${r}.`:(e(u),null)},l=c=>{let u=Number((n+c*t).toFixed(i+1));e(Math.min(r,Math.max(s,u)))};return _(oc,{...o,text:String(Number(n.toFixed(i))),onText:a,onStep:l})}function en({title:n,children:e,actions:t,isOpen:i=!0,testId:s}){let[r,o]=Pt(i);return _("section",{class:"section","data-testid":s,children:[_("div",{class:"section-head",children:[_("h2",{children:_("button",{type:"button",class:"fold","aria-expanded":r,onClick:()=>o(!r),children:n})}),t&&_("div",{class:"actions",children:t})]}),r&&_("div",{class:"section-body",children:e})]})}function ac({title:n,children:e,onClose:t}){let i=Tt(null);return hs(()=>{let s=i.current;return s?.showModal(),()=>s?.close()},[]),_("dialog",{ref:i,class:"dialog","aria-label":n,onClose:t,onClick:s=>s.target===i.current&&t(),children:[_("div",{class:"dialog-head",children:[_("h2",{children:n}),_(Ge,{icon:"close",label:"Close",onClick:t})]}),_("div",{class:"dialog-body",children:e})]})}var zy=[["Everywhere",[["Ctrl+Z, Ctrl+Shift+Z","Undo, redo"],["1, 2","Show or hide the controls, the numbers"],["G, R","Handles that move, turn the OAK"],["P","Points: none, true, measured, both"],["Home","Look at the OAK"],["C","Look from the OAK"],["F","Fly the OAK: it moves with the view"],["[, ]","Select the previous, next OAK"],["Escape","Close, or stop probing"],["?","This list"]]],["3D view, after a click into it or with Tab",[["Drag","Orbit; with Ctrl turn the head; with Shift or the right button pan"],["Wheel","Zoom"],["Drag a pink handle","Resize or move the box of the region; with Shift move it up and down"],["Double click","Put a point into the centre"],["W A S D, Q E","Fly; with Shift faster"],["Arrow keys","Move the OAK by 5 cm; with Shift by 5 mm"],["Page up, page down","Raise, lower the OAK"],["Alt+arrow keys","Turn, tilt the OAK by 2°; with Shift by 0.2°"]]],["Images",[["Mouse, arrow keys","Probe a pixel"],["Drag","Rectangle for the statistics"]]],["Number fields",[["Up, down","One step; with Shift a tenth"]]]];function tg({onClose:n}){return _(ac,{title:"Keys",onClose:n,children:_("div",{class:"keys",children:zy.map(([e,t])=>_("section",{children:[_("h3",{children:e}),_("dl",{children:t.map(([i,s])=>_("div",{children:[_("dt",{children:_("kbd",{children:i})}),_("dd",{children:s})]},i))})]},e))})})}var Vy=4e3,ng={depth:[0,5],error:.05};function lc(n,e){let t=[...n];return{depth:e.depthRange??Hy(t),error:e.errorRange??Wy(t,e.errorUnit)}}function Gy(n){return n.pictures.get("reference")??n.pictures.get("depth")}function Hy(n){let e=[];for(let o of n){let a=Gy(o)?.data??o.pictures.get("sensor")?.data;if(!a)continue;let l=Math.max(1,Math.floor(a.length/Vy));for(let c=0;c<a.length;c+=l)a[c]&&e.push(a[c])}if(e.length===0)return ng.depth;e.sort((o,a)=>o-a);let t=o=>e[Math.floor(o*(e.length-1))]/1e3,[i,s]=[t(.01),t(.99)],r=Math.max(Rd((s-i)/20),.01);return[Number((Math.floor(i/r)*r).toFixed(3)),Number((Math.ceil(s/r)*r).toFixed(3))]}function Wy(n,e){let t=n.map(({header:{statistics:i}})=>e==="mm"?i.p95AbsoluteErrorM??0:(i.medianAbsoluteErrorPercent??0)*3);return Rd(Math.max(0,...t))||(e==="mm"?ng.error:5)}function ig({kinds:n,scales:e}){let t=n.includes("depth")||n.includes("sensor")||n.includes("confidence");return _("div",{class:"legend",children:[t&&_(Xy,{scales:e}),n.includes("error")&&_(qy,{scales:e}),n.includes("reason")&&_(Yy,{}),(t||n.includes("error"))&&_("span",{class:"swatch-label",children:[_("span",{class:"swatch hatch"}),"no value"]})]})}function Xy({scales:n}){let{studio:e}=Ve(),{depthMap:t,depthRange:i}=Ae(e.display),[s,r]=n.depth;return _("div",{class:"scale",role:"group","aria-label":"Depth scale",children:[_("span",{class:"scale-name",children:"Depth"}),_(Mn,{label:"Nearest depth",isLabelled:!1,value:s,minimum:0,maximum:r-.001,step:.1,digits:3,onChange:o=>e.show({depthRange:[o,r]})}),_(sg,{bytes:mo(t)}),_(Mn,{label:"Farthest depth",isLabelled:!1,value:r,minimum:s+.001,maximum:65.535,step:.1,digits:3,unit:"m",onChange:o=>e.show({depthRange:[s,o]})}),_(Ge,{label:"Auto",class:"chip",tip:"Follow the images",isOn:i===null,onClick:()=>e.show({depthRange:i?null:n.depth})}),_(hi,{label:"Colour map",isLabelled:!1,value:t,options:Sm.map(({map:o,title:a})=>({value:o,title:a})),onChange:o=>e.show({depthMap:o}),testId:"depth-map"})]})}function qy({scales:n}){let{studio:e}=Ve(),{errorUnit:t,errorRange:i}=Ae(e.display),s=t==="mm"?1e3:1,r=()=>e.show({errorUnit:t==="mm"?"%":"mm",errorRange:null});return _("div",{class:"scale",role:"group","aria-label":"Error scale",children:[_("span",{class:"scale-name",children:"Error"}),_("span",{class:"end",children:"too near"}),_(sg,{bytes:go()}),_("span",{class:"end",children:"too far"}),_("span",{class:"end",children:"±"}),_(Mn,{label:"End of the error scale",isLabelled:!1,value:n.error*s,minimum:.01,maximum:65535,step:t==="mm"?5:.5,digits:2,onChange:o=>e.show({errorRange:o/s})}),_(Ge,{label:t,class:"chip",tip:"Switch between millimetres and percent",onClick:r,testId:"error-unit"}),_(Ge,{label:"Auto",class:"chip",tip:"Follow the images",isOn:i===null,onClick:()=>e.show({errorRange:i?null:n.error})})]})}function Yy(){let{studio:n}=Ve(),{reasons:e}=Ae(n.catalog),t=Ae(n.frames),i=s=>[...t.values()].some(({header:r})=>(r.statistics.reasons[s]??0)>0);return _("div",{class:"reasons-legend",role:"group","aria-label":"Reasons",children:e.filter(({code:s})=>s===0||i(s)).map(({code:s,name:r,documentation:o})=>_("span",{class:"swatch-label","data-tip":o,children:[_("span",{class:"swatch",style:{background:on(er(s))}}),vn(r)]},s))})}function sg({bytes:n}){let e=Tt(null);return hs(()=>{let t=new ImageData(new Uint8ClampedArray(n),us,1);e.current?.getContext("2d")?.putImageData(t,0,0)},[n]),_("canvas",{ref:e,class:"gradient",width:us,height:1})}var cc=Math.PI/180,rg=[-Math.SQRT1_2,0,0,Math.SQRT1_2];function So([n,e,t,i],[s,r,o,a]){return[i*s+n*a+e*o-t*r,i*r-n*o+e*a+t*s,i*o+n*r-e*s+t*a,i*a-n*s-e*r-t*o]}function og([n,e,t,i]){return[-n,-e,-t,i]}function Ca(n,[e,t,i]){let[s,r,o]=So(So(n,[e,t,i,0]),og(n));return[s,r,o]}function ag(n){let e=Math.hypot(...n)||1;return[n[0]/e,n[1]/e,n[2]/e,n[3]/e]}function Pd(n,e){let t=e*cc/2,i=[0,0,0,Math.cos(t)];return i[n]=Math.sin(t),i}function uc(n){return n==="z"?[0,0,1]:[0,1,0]}function hc({yaw:n,pitch:e,roll:t},i){let s=So(So(Pd(2,n),Pd(1,e)),Pd(0,t));return ag(i==="z"?s:So(rg,s))}function ds(n,e){let[t,i,s,r]=ag(e==="z"?n:So(og(rg),n)),o=Math.max(-1,Math.min(1,2*(r*i-s*t)));return{yaw:Math.atan2(2*(r*s+t*i),1-2*(i*i+s*s))/cc,pitch:Math.asin(o)/cc,roll:Math.atan2(2*(r*t+i*s),1-2*(t*t+i*i))/cc}}function dc(n,[e,t,i],s){let r=hc({yaw:ds(n.quaternion,s).yaw,pitch:0,roll:0},s),[o,a,l]=Ca(r,[e,t,i]),[c,u,h]=n.position;return{...n,position:[c+o,u+a,h+l]}}function fc(n,e,t){let i=ds(n.quaternion,t),s=Math.max(-90,Math.min(90,i.pitch+(e.pitch??0))),r={yaw:i.yaw+(e.yaw??0),pitch:s,roll:i.roll+(e.roll??0)};return{...n,quaternion:hc(r,t)}}function lg({oak:n,kind:e}){let{studio:t}=Ve(),i=Ps(t.document,c=>c.region),s=i.every((c,u)=>c===tr[u]),[r,o,a,l]=i;return _(xt,{children:[!s&&_("div",{class:"region",style:{left:`${r*100}%`,top:`${o*100}%`,width:`${(a-r)*100}%`,height:`${(l-o)*100}%`}}),_($y,{oak:n,kind:e})]})}function $y({oak:n,kind:e}){let{studio:t}=Ve(),i=Ae(t.hover),s=Ae(t.probe),r=Ae(t.catalog);if(!i)return null;let o=t.frames.get().get(n),a=o&&ui(r,o.state);if(!o||!a)return null;let l=s?.point?Zy(o,a,s.point):null,c=i.oak===n?{x:i.x,y:i.y,z:l?.z??null}:l;if(!c||c.x<0||c.x>1||c.y<0||c.y>1)return null;let u=e==="right"?Ky(o,a.baselineM,c.z):0;if(u===null)return null;let h=i.oak!==n;return _("div",{class:`cross ${h?"other":""}`,style:{left:`${(c.x-u)*100}%`,top:`${c.y*100}%`}})}function Zy({header:n,state:e},t,i){let[s,r,o,a]=e.pose.quaternion,{position:l}=e.pose,c=Ca([-s,-r,-o,a],[i[0]-l[0],i[1]-l[1],i[2]-l[2]]),u=t.bodyFromCamera,h=c.map((y,p)=>y-(u[p*4+3]??0)),d=y=>[0,1,2].reduce((p,m)=>p+(u[m*4+y]??0)*(h[m]??0),0),f=d(2);if(f<=0)return null;let g=(y,p)=>.5+y/(2*f*Math.tan(p*Math.PI/360));return{x:g(d(0),n.hfovDeg),y:g(d(1),n.vfovDeg),z:f}}function Ky({header:n},e,t){return!e||!t?null:e/(t*2*Math.tan(n.hfovDeg*Math.PI/360))}var Jy=5;function ug({oak:n,index:e,kind:t,other:i,width:s,scales:r}){let{studio:o}=Ve(),a=Ps(o.frames,f=>f.get(n.key)),l=Ps(o.rejections,f=>f.get(n.key)),c=Ps(o.display,f=>f.wipeAt),u=a?tb(a):1.6,h=f=>Ui.find(g=>g.kind===f)?.title??f,d=Math.round(s/u);return _("figure",{class:`panel ${l&&a?"stale":""}`,"data-testid":`panel-${n.key}-${t}`,children:[_("figcaption",{children:[_("span",{class:"dot-small",style:{background:on(Qn(e))}}),_("span",{class:"panel-title",children:i?`${h(t)} | ${h(i)}`:h(t)}),_("span",{class:"panel-oak",children:n.state.model}),_("span",{class:"spring"}),a&&_("span",{class:`panel-fact ${a.isPreview?"provisional":""}`,children:nb(t,a)}),a&&_(jy,{frame:a})]}),_(rb,{oak:n.key,label:`${h(t)} of ${n.state.model}`,width:s,height:d,children:[_(cg,{oak:n.key,kind:t,frame:a,width:s,height:d,scales:r}),i&&_("div",{class:"wiped",style:{clipPath:`inset(0 0 0 ${c*100}%)`},children:_(cg,{oak:n.key,kind:i,frame:a,width:s,height:d,scales:r})}),i&&_(Qy,{at:c,width:s}),_(lg,{oak:n.key,kind:t}),l&&a&&_("p",{class:"stale-note",children:`Not measured: ${l.error}`}),!a&&_("p",{class:"empty",children:eb(l?.error,o.hasDepth(n.state),n.state.model)})]})]})}function Qy({at:n,width:e}){let{studio:t}=Ve(),i=s=>{s.stopPropagation();let r=s.clientX,o=a=>t.show({wipeAt:Math.max(0,Math.min(1,n+(a.clientX-r)/e))});addEventListener("pointermove",o),addEventListener("pointerup",()=>removeEventListener("pointermove",o),{once:!0})};return _("div",{class:"edge",style:{left:`${n*100}%`},onPointerDown:i})}function jy({frame:n}){let e=n.pictures.get("sensor");if(!e)return null;let t=`${e.width} × ${e.height}`;return n.isPreview?_("span",{class:"fineness preview","data-testid":"fineness","data-tip":"Coarse while something changes; the final image follows",children:`preview ${t}`}):_("span",{class:"fineness","data-testid":"fineness",children:t})}function eb(n,e,t){return n||(e?"Measuring…":`${t} has no depth sensor.`)}function tb(n){let e=n.pictures.get("sensor")??[...n.pictures.values()][0];return e?e.width/e.height:1.6}function nb(n,{header:{statistics:e}}){return n==="sensor"||n==="reason"?`${Lr(e.fillRate)} filled`:n==="error"?`median ${ir(e.medianErrorM)}`:""}function cg({oak:n,kind:e,frame:t,width:i,height:s,scales:r}){let{painter:o,repaint:a,studio:l,signals:c}=Ve(),u=Ae(l.display),h=Ae(a),d=Tt(null),[f,g]=Pt(!1),y=t?.pictures.get(e==="error"?"sensor":e),p=Math.min(devicePixelRatio*i,y?.width??640)/i,{depthMap:m,errorUnit:v}=u,E=e==="error"||e==="depth"?t?.pictures.get("reference")??t?.pictures.get("depth"):void 0,S=e==="error"?[r.error]:e==="depth"||e==="sensor"?r.depth:[];return hs(()=>{let R=d.current;if(!R||!t)return;let[C,x]=[Math.max(1,Math.round(i*p)),Math.max(1,Math.round(s*p))];R.width!==C&&(R.width=C),R.height!==x&&(R.height=x),g(!o.paint(R,{oak:n,kind:e,frame:t,display:u,scales:r,empty:sb()})),c.painted++},[y,E,i,s,p,S[0],S[1],m,v,e,h,u.theme,t===void 0]),_(xt,{children:[_("canvas",{ref:d,class:"picture"}),f&&t&&_("p",{class:"empty",children:ib(e,t)})]})}function ib(n,e){let{engine:t,model:i}=e.state;return(Ui.find(r=>r.kind===n)?.images??[]).every(r=>e.requested.includes(r))?n==="confidence"?`${t} makes no confidence.`:n==="left"||n==="right"?`${i} has no stereo pair here.`:"This image is not available.":"Measuring…"}function sb(){let n=getComputedStyle(document.documentElement);return["--empty","--empty-line"].flatMap(e=>{let t=Number.parseInt(n.getPropertyValue(e).trim().slice(1),16);return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]})}function rb({oak:n,label:e,width:t,height:i,children:s}){let{studio:r}=Ve(),o=Tt(null),a=Tt(()=>{});Gt(()=>()=>a.current(),[]);let l=d=>{let f=o.current?.getBoundingClientRect()??new DOMRect(0,0,1,1),g=y=>Math.max(0,Math.min(.99999,y));return[g((d.clientX-f.left)/f.width),g((d.clientY-f.top)/f.height)]},c=d=>{let[f,g]=l(d);r.hover.set({oak:n,x:f,y:g})},u=d=>{if(d.button!==0)return;let[f,g]=l(d),[y,p]=[d.clientX,d.clientY],m=E=>{if(Math.hypot(E.clientX-y,E.clientY-p)<Jy)return;let[S,R]=l(E),C=[Math.min(f,S),Math.min(g,R),Math.max(f,S),Math.max(g,R)];r.document.commit("region",x=>({...x,region:C}))},v=()=>{removeEventListener("pointermove",m),removeEventListener("pointerup",v)};a.current=v,addEventListener("pointermove",m),addEventListener("pointerup",v)},h=d=>{let[f,g]={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[d.key]??[0,0];if(f===0&&g===0)return;d.preventDefault(),d.stopPropagation();let y=d.shiftKey?.002:.02,{x:p,y:m}=r.hover.get()??{x:.5,y:.5},v=E=>Math.max(0,Math.min(.99999,E));r.hover.set({oak:n,x:v(p+(f??0)*y),y:v(m+(g??0)*y)})};return _("div",{ref:o,class:"surface",role:"application","aria-label":`${e}. Arrow keys move the probed pixel.`,tabIndex:0,style:{width:`${t}px`,height:`${i}px`},onPointerMove:c,onPointerDown:u,onKeyDown:h,children:s})}var ob=1.7,hg=6,dg=1.6,ab=150;function lb(n,e,t,i,s){let r=i*s,o=i>1&&s>1?[s,i]:Array.from({length:r},(c,u)=>u+1),a=ob*Number.parseFloat(getComputedStyle(document.documentElement).fontSize),l={count:1,width:0};for(let c of o){let u=Math.ceil(r/c),h=Math.min((n-hg*(c-1))/c,((e-hg*(u-1))/u-a)*t);h>l.width&&(l={count:c,width:h})}return{count:l.count,width:Math.max(ab,Math.floor(l.width))}}function fg(){let{studio:n}=Ve(),e=Ae(n.display),t=Ae(n.frames),{oaks:i}=Ae(n.document),s=i.filter(y=>!y.isHidden),r=Ir(()=>lc(t.values(),e),[t,e]),o=e.wipe?[e.wipe.left]:Ui.map(({kind:y})=>y).filter(y=>e.panels.includes(y)),a=Tt(null),[l,c]=Pt({width:800,height:300});hs(()=>{let y=a.current;if(!y)return;let p=new ResizeObserver(()=>c({width:y.clientWidth-16,height:y.clientHeight-12}));return p.observe(y),()=>p.disconnect()},[]);let u=[...t.values()].map(({pictures:y})=>y.get("sensor")).map(y=>y?y.width/y.height:dg),h=u.length?Math.min(...u):dg,d=lb(l.width,l.height,h,s.length,Math.max(o.length,1)),g=s.length>1&&o.length>1&&d.count===s.length&&d.count!==o.length?o.flatMap(y=>s.map(p=>[p,y])):s.flatMap(y=>o.map(p=>[y,p]));return _("section",{class:"images","aria-label":"Images",children:[_(ub,{}),_("div",{class:"panels",ref:a,children:[_("div",{class:"grid",style:{gridTemplateColumns:`repeat(${d.count}, ${d.width}px)`},children:g.map(([y,p])=>_(ug,{oak:y,index:i.indexOf(y),kind:p,other:e.wipe?.right??null,width:d.width,scales:r},`${y.key}/${p}`))}),g.length===0&&_("p",{class:"hint pad",children:"Choose at least one image above."})]}),_(ig,{kinds:[...e.wipe?[e.wipe.left,e.wipe.right]:o,...cb(e)],scales:r})]})}function cb({cloud:n,cloudColor:e}){return n==="none"||e==="oak"?[]:[e]}function ub(){let{studio:n}=Ve(),e=Ae(n.display),t=r=>{let o=e.panels.includes(r)?e.panels.filter(a=>a!==r):[...e.panels,r];n.show({panels:o})},i=Ui.map(({kind:r,title:o})=>({value:r,title:o})),{wipe:s}=e;return _("div",{class:"bar",role:"toolbar","aria-label":"Images that are shown",children:[s?_(xt,{children:[_(hi,{label:"Left of the edge",isLabelled:!1,value:s.left,options:i,onChange:r=>n.show({wipe:{...s,left:r}})}),_("input",{type:"range",class:"wipe-at",min:0,max:1,step:.01,"aria-label":"Edge of the wipe",value:e.wipeAt,onInput:r=>n.show({wipeAt:Number(r.currentTarget.value)})}),_(hi,{label:"Right of the edge",isLabelled:!1,value:s.right,options:i,onChange:r=>n.show({wipe:{...s,right:r}})})]}):Ui.map(({kind:r,title:o,help:a})=>_(Ge,{label:o,class:"chip",tip:a,isOn:e.panels.includes(r),onClick:()=>t(r),testId:`show-${r}`},r)),_("span",{class:"spring"}),_(Ge,{label:"Wipe",class:"chip",tip:"Two images in one panel with a movable edge",isOn:s!==null,onClick:()=>n.show({wipe:s?null:{left:"depth",right:"sensor"}})}),_(hi,{label:"Image size at rest",isLabelled:!1,value:e.fullSize,options:yo.map(({size:r,title:o})=>({value:r,title:o})),onChange:r=>n.show({fullSize:r}),testId:"full-size"})]})}var hb="uplot",db="u-hz",fb="u-vt",pb="u-title",mb="u-wrap",gb="u-under",_b="u-over",vb="u-axis",Fr="u-off",xb="u-select",yb="u-cursor-x",bb="u-cursor-y",Sb="u-cursor-pt",Mb="u-legend",wb="u-live",Eb="u-inline",Tb="u-series",Ab="u-marker",pg="u-label",Cb="u-value",Pa="width",Ia="height";var mg="bottom",Mo="left",Id="right",$d="#000",gg=$d+"0",Ld="mousemove",_g="mousedown",Dd="mouseup",vg="mouseenter",xg="mouseleave",yg="dblclick",Rb="resize",Pb="scroll",bg="change",vc="dppxchange",Zd="--",Po=typeof window<"u",kd=Po?document:null,Eo=Po?window:null,Ib=Po?navigator:null,It,pc;function Bd(){let n=devicePixelRatio;It!=n&&(It=n,pc&&Vd(bg,pc,Bd),pc=matchMedia(`(min-resolution: ${It-.001}dppx) and (max-resolution: ${It+.001}dppx)`),Ur(bg,pc,Bd),Eo.dispatchEvent(new CustomEvent(vc)))}function Ei(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function zd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function tn(n,e,t){n.style[e]=t+"px"}function Xi(n,e,t,i){let s=kd.createElement(n);return e!=null&&Ei(s,e),t?.insertBefore(s,i),s}function ki(n,e){return Xi("div",n,e)}var Sg=new WeakMap;function fs(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Sg.get(n);r!=o&&(n.style.transform=r,Sg.set(n,r),e<0||t<0||e>i||t>s?Ei(n,Fr):zd(n,Fr))}var Mg=new WeakMap;function wg(n,e,t){let i=e+t,s=Mg.get(n);i!=s&&(Mg.set(n,i),n.style.background=e,n.style.borderColor=t)}var Eg=new WeakMap;function Tg(n,e,t,i){let s=e+""+t,r=Eg.get(n);s!=r&&(Eg.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Kd={passive:!0},Lb={...Kd,capture:!0};function Ur(n,e,t,i){e.addEventListener(n,t,i?Lb:Kd)}function Vd(n,e,t,i){e.removeEventListener(n,t,Kd)}Po&&Bd();function qi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Ti((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function e0(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var t0=n=>n!=null,n0=n=>n!=null&&n>0,bc=e0(t0),Db=e0(n0);function Nb(n,e,t,i=0,s=!1){let r=s?Db:bc,o=s?n0:t0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Wt,l??-Wt]}function Sc(n,e,t,i){let s=Rg(n),r=Rg(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Is:i0,a=s==1?Ti:Bi,l=r==1?Bi:Ti,c=a(o(On(n))),u=l(o(On(e))),h=To(t,c),d=To(t,u);return t==10&&(c<0&&(h=Xt(h,-c)),u<0&&(d=Xt(d,-u))),i||t==2?(n=h*s,e=d*r):(n=a0(n,h),e=Mc(e,d)),[n,e]}function Jd(n,e,t,i){let s=Sc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Qd=.1,Ag={mode:3,pad:Qd},Da={pad:0,soft:null,mode:0},Fb={min:Da,max:Da};function xc(n,e,t,i){return wc(t)?Cg(n,e,t):(Da.pad=t,Da.soft=i?0:null,Da.mode=i?3:0,Cg(n,e,Fb))}function Ct(n,e){return n??e}function Ub(n,e,t){for(e=Ct(e,0),t=Ct(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Cg(n,e,t){let i=t.min,s=t.max,r=Ct(i.pad,0),o=Ct(s.pad,0),a=Ct(i.hard,-Wt),l=Ct(s.hard,Wt),c=Ct(i.soft,Wt),u=Ct(s.soft,-Wt),h=Ct(i.mode,0),d=Ct(s.mode,0),f=e-n,g=Is(f),y=di(On(n),On(e)),p=Is(y),m=On(p-g);(f<1e-24||m>10)&&(f=0,(n==0||e==0)&&(f=1e-24,h==2&&c!=Wt&&(r=0),d==2&&u!=-Wt&&(o=0)));let v=f||y||1e3,E=Is(v),S=To(10,Ti(E)),R=v*(f==0?n==0?.1:1:r),C=Xt(a0(n-R,S/10),24),x=n>=c&&(h==1||h==3&&C<=c||h==2&&C>=c)?c:Wt,w=di(a,C<x&&n>=x?x:Yi(x,C)),O=v*(f==0?e==0?.1:1:o),I=Xt(Mc(e+O,S/10),24),D=e<=u&&(d==1||d==3&&I>=u||d==2&&I<=u)?u:-Wt,z=Yi(l,I>D&&e<=D?D:di(D,I));return w==z&&w==0&&(z=100),[w,z]}var Ob=new Intl.NumberFormat(Po?Ib.language:"en-US"),jd=n=>Ob.format(n),Ai=Math,_c=Ai.PI,On=Ai.abs,Ti=Ai.floor,Un=Ai.round,Bi=Ai.ceil,Yi=Ai.min,di=Ai.max,To=Ai.pow,Rg=Ai.sign,Is=Ai.log10,i0=Ai.log2,kb=(n,e=1)=>Ai.sinh(n)*e,Nd=(n,e=1)=>Ai.asinh(n/e),Wt=1/0;function Pg(n){return(Is((n^n>>31)-(n>>31))|0)+1}function Gd(n,e,t){return Yi(di(n,e),t)}function s0(n){return typeof n=="function"}function bt(n){return s0(n)?n:()=>n}var Bb=()=>{},r0=n=>n,o0=(n,e)=>e,zb=n=>null,Ig=n=>!0,Lg=(n,e)=>n==e,Vb=/\.\d*?(?=9{6,}|0{6,})/gm,Or=n=>{if(c0(n)||ar.has(n))return n;let e=`${n}`,t=e.match(Vb);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Or(s)}e${r}`}return Xt(n,i)};function Dr(n,e){return Or(Xt(Or(n/e))*e)}function Mc(n,e){return Or(Bi(Or(n/e))*e)}function a0(n,e){return Or(Ti(Or(n/e))*e)}function Xt(n,e=0){if(c0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Un(i)/t}var ar=new Map;function l0(n){return((""+n).split(".")[1]||"").length}function Fa(n,e,t,i){let s=[],r=i.map(l0);for(let o=e;o<t;o++){let a=On(o),l=Xt(To(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Xt(u,h);s.push(d),ar.set(d,h)}}return s}var Na={},ef=[],Ao=[null,null],or=Array.isArray,c0=Number.isInteger,Gb=n=>n===void 0;function Dg(n){return typeof n=="string"}function wc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Hb(n){return n!=null&&typeof n=="object"}var Wb=Object.getPrototypeOf(Uint8Array),u0="__proto__";function Co(n,e=wc){let t;if(or(n)){let i=n.find(s=>s!=null);if(or(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Co(n[s],e)}else t=n.slice()}else if(n instanceof Wb)t=n.slice();else if(e(n)){t={};for(let i in n)i!=u0&&(t[i]=Co(n[i],e))}else t=n;return t}function Pn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=u0&&(wc(n[s])?Pn(n[s],Co(i[s])):n[s]=Co(i[s]))}return n}var Xb=0,qb=1,Yb=2;function $b(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Zb(n,e){if(Qb(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return jb(o[0])||(o=Jb(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:qb,f=[];for(let g=0;g<u.length;g++){let y=u[g],p=r.get(l[g]);y===null?d!=Xb&&(h[p]=y,d==Yb&&f.push(p)):h[p]=y}$b(h,f,s),i.push(h)}}return i}var Kb=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Jb(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Qb(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function jb(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=di(1,Ti((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var h0=["January","February","March","April","May","June","July","August","September","October","November","December"],d0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function f0(n){return n.slice(0,3)}var eS=d0.map(f0),tS=h0.map(f0),nS={MMMM:h0,MMM:tS,WWWW:d0,WWW:eS};function Ra(n){return(n<10?"0":"")+n}function iS(n){return(n<10?"00":n<100?"0":"")+n}var sS={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ra(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ra(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ra(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ra(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ra(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>iS(n.getMilliseconds())};function tf(n,e){e=e||nS;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?sS[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var rS=new Intl.DateTimeFormat().resolvedOptions().timeZone;function oS(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==rS?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var p0=n=>n%1==0,yc=[1,2,2.5,5],aS=Fa(10,-32,0,yc),m0=Fa(10,0,32,yc),lS=m0.filter(p0),Nr=aS.concat(m0),nf=`
`,g0="{YYYY}",Ng=nf+g0,_0="{M}/{D}",La=nf+_0,mc=La+"/{YY}",v0="{aa}",cS="{h}:{mm}",wo=cS+v0,Fg=nf+wo,Ug=":{ss}",Lt=null;function x0(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Fa(10,0,3,yc).filter(p0):Fa(10,-3,0,yc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,g0,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",Ng,Lt,Lt,Lt,Lt,Lt,1],[s,_0,Ng,Lt,Lt,Lt,Lt,Lt,1],[i,"{h}"+v0,mc,Lt,La,Lt,Lt,Lt,1],[t,wo,mc,Lt,La,Lt,Lt,Lt,1],[e,Ug,mc+" "+wo,Lt,La+" "+wo,Lt,Fg,Lt,1],[n,Ug+".{fff}",mc+" "+wo,Lt,La+" "+wo,Lt,Fg,Lt,1]];function u(h){return(d,f,g,y,p,m)=>{let v=[],E=p>=o,S=p>=r&&p<o,R=h(g),C=Xt(R*n,3),x=Fd(R.getFullYear(),E?0:R.getMonth(),S||E?1:R.getDate()),w=Xt(x*n,3);if(S||E){let O=S?p/r:0,I=E?p/o:0,D=C==w?C:Xt(Fd(x.getFullYear()+I,x.getMonth()+O,1)*n,3),z=new Date(Un(D/n)),G=z.getFullYear(),N=z.getMonth();for(let W=0;D<=y;W++){let $=Fd(G+I*W,N+O*W,1),H=$-h(Xt($*n,3));D=Xt((+$+H)*n,3),D<=y&&v.push(D)}}else{let O=p>=s?s:p,I=Ti(g)-Ti(C),D=w+I+Mc(C-w,O);v.push(D);let z=h(D),G=z.getHours()+z.getMinutes()/t+z.getSeconds()/i,N=p/i,W=d.axes[f]._space,$=m/W;for(;D=Xt(D+p,n==1?0:3),!(D>y);)if(N>1){let H=Ti(Xt(G+N,6))%24,j=h(D).getHours()-H;j>1&&(j=-1),D-=j*i,G=(G+N)%24;let ie=v[v.length-1];Xt((D-ie)/p,3)*$>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,u]}var[uS,hS,dS]=x0(1),[fS,pS,mS]=x0(.001);Fa(2,-53,53,[1]);function Og(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function kg(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,h,d,f;return i.map(g=>{let y=n(g),p=y.getFullYear(),m=y.getMonth(),v=y.getDate(),E=y.getHours(),S=y.getMinutes(),R=y.getSeconds(),C=p!=l&&a[2]||m!=c&&a[3]||v!=u&&a[4]||E!=h&&a[5]||S!=d&&a[6]||R!=f&&a[7]||a[1];return l=p,c=m,u=v,h=E,d=S,f=R,C(y)})}}function gS(n,e){let t=tf(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Fd(n,e,t){return new Date(n,e,t)}function Bg(n,e){return e(n)}var _S="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function zg(n,e){return(t,i,s,r)=>r==null?Zd:e(n(i))}function vS(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function xS(n,e){return n.series[e].fill(n,e)}var yS={show:!0,live:!0,isolate:!1,mount:Bb,markers:{show:!0,width:2,stroke:vS,fill:xS,dash:"solid"},idx:null,idxs:null,values:[]};function bS(n,e){let t=n.cursor.points,i=ki(),s=t.size(n,e);tn(i,Pa,s),tn(i,Ia,s);let r=s/-2;tn(i,"marginLeft",r),tn(i,"marginTop",r);let o=t.width(n,e,s);return o&&tn(i,"borderWidth",o),i}function SS(n,e){let t=n.series[e].points;return t._fill||t._stroke}function MS(n,e){let t=n.series[e].points;return t._stroke||t._fill}function wS(n,e){return n.series[e].points.size}var Ud=[0,0];function ES(n,e,t){return Ud[0]=e,Ud[1]=t,Ud}function gc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Od(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var TS={show:!0,x:!0,y:!0,lock:!1,move:ES,points:{one:!1,show:bS,size:wS,width:0,stroke:MS,fill:SS},bind:{mousedown:gc,mouseup:gc,click:gc,dblclick:gc,mousemove:Od,mouseleave:Od,mouseenter:Od},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},y0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},sf=Pn({},y0,{filter:o0}),b0=Pn({},sf,{size:10}),S0=Pn({},y0,{show:!1}),rf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',M0="bold "+rf,w0=1.5,Vg={show:!0,scale:"x",stroke:$d,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:M0,side:2,grid:sf,ticks:b0,border:S0,font:rf,lineGap:w0,rotate:0},AS="Value",CS="Time",Gg={show:!0,scale:"x",auto:!1,sorted:1,min:Wt,max:-Wt,idxs:[]};function RS(n,e,t,i,s){return e.map(r=>r==null?"":jd(r))}function PS(n,e,t,i,s,r,o){let a=[],l=ar.get(s)||0;t=o?t:Xt(Mc(t,s),l);for(let c=t;c<=i;c=Xt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Hd(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Is:i0,u=Ti(c(t));s=To(l,u),l==10&&(s=Nr[qi(s,Nr)]);let h=t,d=s*l;l==10&&(d=Nr[qi(d,Nr)]);do a.push(h),h=h+s,l==10&&!ar.has(h)&&(h=Xt(h,ar.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Nr[qi(d,Nr)]));while(h<=i);return a}function IS(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Hd(n,e,di(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Hd(n,e,di(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var E0=/./,LS=/[12357]/,DS=/[125]/,Hg=/1/,Wd=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function NS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?E0:l(7,o)-u>=c?LS:l(5,o)-u>=c?DS:Hg;if(h==Hg){let d=On(l(1,o)-u);if(d<c)return Wd(e.slice().reverse(),a.distr,h,Bi(c/d)).reverse()}return Wd(e,a.distr,h,1)}function FS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=On(l(1,o)-l(2,o));return c<a?Wd(e.slice().reverse(),3,E0,Bi(a/c)).reverse():e}function US(n,e,t,i){return i==null?Zd:e==null?"":jd(e)}var Wg={show:!0,scale:"y",stroke:$d,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:M0,side:3,grid:sf,ticks:b0,border:S0,font:rf,lineGap:w0,rotate:0};function OS(n,e){let t=3+(n||1)*2;return Xt(t*e,3)}function kS(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=On(o-r),l=n.series[e],c=a/(l.points.space*It);return i[1]-i[0]<=c}var Xg={scale:null,auto:!0,sorted:0,min:Wt,max:-Wt},T0=(n,e,t,i,s)=>s,qg={show:!0,auto:!0,sorted:0,gaps:T0,alpha:1,facets:[Pn({},Xg,{scale:"x"}),Pn({},Xg,{scale:"y"})]},Yg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:T0,alpha:1,points:{show:kS,filter:null},values:null,min:Wt,max:-Wt,idxs:[],path:null,clip:null};function BS(n,e,t,i,s){return t/10}var A0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},zS=Pn({},A0,{time:!1,ori:1}),$g={};function C0(n,e){let t=$g[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&($g[n]=t)),t}var Ro=1,Xd=2;function kr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,y=a.height,p=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,h,p,m,d,f,g,y,Tc,Io,Cc,P0,L0):t(s,l,c,u,h,m,p,f,d,y,g,Ac,Lo,lf,I0,D0)}function of(n,e){let t=0,i=0,s=Ct(n.bands,ef);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function VS(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ls(n,e,t,i,s,r){return kr(n,e,(o,a,l,c,u,h,d,f,g,y,p)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),E=c.ori==0?Io:Lo,S,R;v==1?(S=t,R=i):(S=i,R=t);let C=m(h(a[S],c,y,f)),x=m(d(l[S],u,p,g)),w=m(h(a[R],c,y,f)),O=m(d(r==1?u.max:u.min,u,p,g)),I=new Path2D(s);return E(I,w,O),E(I,C,O),E(I,C,x),I})}function Ec(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Cc:lf,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function GS(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function af(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[h]),g=d==h?f:r(n[d]),y=h-s;f=o<=0&&y>=0&&y<l?r(n[y]):f;let m=d+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=f&&a.push([f,g])}return a}function Zg(n){return n==0?r0:n==1?Un:e=>Dr(e,n)}function R0(n){let e=n==0?Tc:Ac,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Yi(c,a/2,l/2),u=Yi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Tc=(n,e,t)=>{n.moveTo(e,t)},Ac=(n,e,t)=>{n.moveTo(t,e)},Io=(n,e,t)=>{n.lineTo(e,t)},Lo=(n,e,t)=>{n.lineTo(t,e)},Cc=R0(0),lf=R0(1),P0=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},I0=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},L0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},D0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function N0(n){return(e,t,i,s,r)=>kr(e,t,(o,a,l,c,u,h,d,f,g,y,p)=>{let{pxRound:m,points:v}=o,E,S;c.ori==0?(E=Tc,S=P0):(E=Ac,S=I0);let R=Xt(v.width*It,3),C=(v.size-v.width)/2*It,x=Xt(C*2,3),w=new Path2D,O=new Path2D,{left:I,top:D,width:z,height:G}=e.bbox;Cc(O,I-x,D-x,z+x*2,G+x*2);let N=W=>{if(l[W]!=null){let $=m(h(a[W],c,y,f)),H=m(d(l[W],u,p,g));E(w,$+C,H),S(w,$,H,C,0,_c*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:R>0?w:null,fill:w,clip:O,flags:Ro|Xd}})}function F0(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var HS=F0(Io),WS=F0(Lo);function U0(n){let e=Ct(n?.alignGaps,0);return(t,i,s,r)=>kr(t,i,(o,a,l,c,u,h,d,f,g,y,p)=>{[s,r]=bc(l,s,r);let m=o.pxRound,v=G=>m(h(G,c,y,f)),E=G=>m(d(G,u,p,g)),S,R;c.ori==0?(S=Io,R=HS):(S=Lo,R=WS);let C=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ro},w=x.stroke,O=!1;if(r-s>=y*4){let G=de=>t.posToVal(de,c.key,!0),N=null,W=null,$,H,le,Y=v(a[C==1?s:r]),j=v(a[s]),ie=v(a[r]),he=G(C==1?j+1:ie-1);for(let de=C==1?s:r;de>=s&&de<=r;de+=C){let ee=a[de],ve=(C==1?ee<he:ee>he)?Y:v(ee),Ce=l[de];ve==Y?Ce!=null?(H=Ce,N==null?(S(w,ve,E(H)),$=N=W=H):H<N?N=H:H>W&&(W=H)):Ce===null&&(O=!0):(N!=null&&R(w,Y,E(N),E(W),E($),E(H)),Ce!=null?(H=Ce,S(w,ve,E(H)),N=W=$=H):(N=W=null,Ce===null&&(O=!0)),Y=ve,he=G(Y+C))}N!=null&&N!=W&&le!=Y&&R(w,Y,E(N),E(W),E($),E(H))}else for(let G=C==1?s:r;G>=s&&G<=r;G+=C){let N=l[G];N===null?O=!0:N!=null&&S(w,v(a[G]),E(N))}let[D,z]=of(t,i);if(o.fill!=null||D!=0){let G=x.fill=new Path2D(w),N=o.fillTo(t,i,o.min,o.max,D),W=E(N),$=v(a[s]),H=v(a[r]);C==-1&&([H,$]=[$,H]),S(G,H,W),S(G,$,W)}if(!o.spanGaps){let G=[];O&&G.push(...af(a,l,s,r,C,v,e)),x.gaps=G=o.gaps(t,i,s,r,G),x.clip=Ec(G,c.ori,f,g,y,p)}return z!=0&&(x.band=z==2?[Ls(t,i,s,r,w,-1),Ls(t,i,s,r,w,1)]:Ls(t,i,s,r,w,z)),x})}function XS(n){let e=Ct(n.align,1),t=Ct(n.ascDesc,!1),i=Ct(n.alignGaps,0),s=Ct(n.extend,!1);return(r,o,a,l)=>kr(r,o,(c,u,h,d,f,g,y,p,m,v,E)=>{[a,l]=bc(h,a,l);let S=c.pxRound,{left:R,width:C}=r.bbox,x=j=>S(g(j,d,v,p)),w=j=>S(y(j,f,E,m)),O=d.ori==0?Io:Lo,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ro},D=I.stroke,z=d.dir*(d.ori==0?1:-1),G=w(h[z==1?a:l]),N=x(u[z==1?a:l]),W=N,$=N;s&&e==-1&&($=R,O(D,$,G)),O(D,N,G);for(let j=z==1?a:l;j>=a&&j<=l;j+=z){let ie=h[j];if(ie==null)continue;let he=x(u[j]),de=w(ie);e==1?O(D,he,G):O(D,W,de),O(D,he,de),G=de,W=he}let H=W;s&&e==1&&(H=R+C,O(D,H,G));let[le,Y]=of(r,o);if(c.fill!=null||le!=0){let j=I.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,le),he=w(ie);O(j,H,he),O(j,$,he)}if(!c.spanGaps){let j=[];j.push(...af(u,h,a,l,z,x,i));let ie=c.width*It/2,he=t||e==1?ie:-ie,de=t||e==-1?-ie:ie;j.forEach(ee=>{ee[0]+=he,ee[1]+=de}),I.gaps=j=c.gaps(r,o,a,l,j),I.clip=Ec(j,d.ori,p,m,v,E)}return Y!=0&&(I.band=Y==2?[Ls(r,o,a,l,D,-1),Ls(r,o,a,l,D,1)]:Ls(r,o,a,l,D,Y)),I})}function Kg(n,e,t,i,s,r,o=Wt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=On(n[l]-n[a]);u<c&&(c=u,o=On(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function qS(n){n=n||Na;let e=Ct(n.size,[.6,Wt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=bt(s),o=1-e[0],a=Ct(e[1],Wt),l=Ct(e[2],1),c=Ct(n.disp,Na),u=Ct(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,g,y,p)=>kr(f,g,(m,v,E,S,R,C,x,w,O,I,D)=>{let z=m.pxRound,G=t,N=i*It,W=a*It,$=l*It,H,le;S.ori==0?[H,le]=r(f,g):[le,H]=r(f,g);let Y=S.dir*(S.ori==0?1:-1),j=S.ori==0?Cc:lf,ie=S.ori==0?u:(Pe,Ke,lt,Me,Ht,We,Ze)=>{u(Pe,Ke,lt,Ht,Me,Ze,We)},he=Ct(f.bands,ef).find(Pe=>Pe.series[0]==g),de=he!=null?he.dir:0,ee=m.fillTo(f,g,m.min,m.max,de),me=z(x(ee,R,D,O)),ve,Ce,Se,Ye=I,at=z(m.width*It),Xe=!1,pt=null,ht=null,rt=null,sn=null;h!=null&&(at==0||d!=null)&&(Xe=!0,pt=h.values(f,g,y,p),ht=new Map,new Set(pt).forEach(Pe=>{Pe!=null&&ht.set(Pe,new Path2D)}),at>0&&(rt=d.values(f,g,y,p),sn=new Map,new Set(rt).forEach(Pe=>{Pe!=null&&sn.set(Pe,new Path2D)})));let{x0:Yt,size:wn}=c;if(Yt!=null&&wn!=null){G=1,v=Yt.values(f,g,y,p),Yt.unit==2&&(v=v.map(lt=>f.posToVal(w+lt*I,S.key,!0)));let Pe=wn.values(f,g,y,p);wn.unit==2?Ce=Pe[0]*I:Ce=C(Pe[0],S,I,w)-C(0,S,I,w),Ye=Kg(v,E,C,S,I,w,Ye),Se=Ye-Ce+N}else Ye=Kg(v,E,C,S,I,w,Ye),Se=Ye*o+N,Ce=Ye-Se;Se<1&&(Se=0),at>=Ce/2&&(at=0),Se<5&&(z=r0);let zt=Se>0,zn=Ye-Se-(zt?at:0);Ce=z(Gd(zn,$,W)),ve=(G==0?Ce/2:G==Y?0:Ce)-G*Y*((G==0?N/2:0)+(zt?at/2:0));let Et={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Dn=Xe?null:new Path2D,dn=null;if(he!=null)dn=f.data[he.series[1]];else{let{y0:Pe,y1:Ke}=c;Pe!=null&&Ke!=null&&(E=Ke.values(f,g,y,p),dn=Pe.values(f,g,y,p))}let En=H*Ce,B=le*Ce;for(let Pe=Y==1?y:p;Pe>=y&&Pe<=p;Pe+=Y){let Ke=E[Pe];if(Ke==null)continue;if(dn!=null){let q=dn[Pe]??0;if(Ke-q==0)continue;me=x(q,R,D,O)}let lt=S.distr!=2||c!=null?v[Pe]:Pe,Me=C(lt,S,I,w),Ht=x(Ct(Ke,ee),R,D,O),We=z(Me-ve),Ze=z(di(Ht,me)),P=z(Yi(Ht,me)),M=Ze-P;if(Ke!=null){let q=Ke<0?B:En,ue=Ke<0?En:B;Xe?(at>0&&rt[Pe]!=null&&j(sn.get(rt[Pe]),We,P+Ti(at/2),Ce,di(0,M-at),q,ue),pt[Pe]!=null&&j(ht.get(pt[Pe]),We,P+Ti(at/2),Ce,di(0,M-at),q,ue)):j(Dn,We,P+Ti(at/2),Ce,di(0,M-at),q,ue),ie(f,g,Pe,We-at/2,P,Ce+at,M)}}return at>0?Et.stroke=Xe?sn:Dn:Xe||(Et._fill=m.width==0?m._fill:m._stroke??m._fill,Et.width=0),Et.fill=Xe?ht:Dn,Et})}function YS(n,e){let t=Ct(e?.alignGaps,0);return(i,s,r,o)=>kr(i,s,(a,l,c,u,h,d,f,g,y,p,m)=>{[r,o]=bc(c,r,o);let v=a.pxRound,E=H=>v(d(H,u,p,g)),S=H=>v(f(H,h,m,y)),R,C,x;u.ori==0?(R=Tc,x=Io,C=L0):(R=Ac,x=Lo,C=D0);let w=u.dir*(u.ori==0?1:-1),O=E(l[w==1?r:o]),I=O,D=[],z=[];for(let H=w==1?r:o;H>=r&&H<=o;H+=w)if(c[H]!=null){let Y=l[H],j=E(Y);D.push(I=j),z.push(S(c[H]))}let G={stroke:n(D,z,R,x,C,v),fill:null,clip:null,band:null,gaps:null,flags:Ro},N=G.stroke,[W,$]=of(i,s);if(a.fill!=null||W!=0){let H=G.fill=new Path2D(N),le=a.fillTo(i,s,a.min,a.max,W),Y=S(le);x(H,I,Y),x(H,O,Y)}if(!a.spanGaps){let H=[];H.push(...af(l,c,r,o,w,E,t)),G.gaps=H=a.gaps(i,s,r,o,H),G.clip=Ec(H,u.ori,g,y,p,m)}return $!=0&&(G.band=$==2?[Ls(i,s,r,o,N,-1),Ls(i,s,r,o,N,1)]:Ls(i,s,r,o,N,$)),G})}function $S(n){return YS(ZS,n)}function ZS(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var qd=new Set;function Jg(){for(let n of qd)n.syncRect(!0)}Po&&(Ur(Rb,Eo,Jg),Ur(Pb,Eo,Jg,!0),Ur(vc,Eo,()=>{$n.pxRatio=It}));var KS=U0(),JS=N0();function Qg(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Yd(r,o,e,t))}function QS(n,e){return n.map((t,i)=>i==0?{}:Pn({},e,t))}function Yd(n,e,t,i){return Pn({},e==0?t:i,n)}function O0(n,e,t){return e==null?Ao:[e,t]}var jS=O0;function eM(n,e,t){return e==null?Ao:xc(e,t,Qd,!0)}function k0(n,e,t,i){return e==null?Ao:Sc(e,t,n.scales[i].log,!1)}var tM=k0;function B0(n,e,t,i){return e==null?Ao:Jd(e,t,n.scales[i].log,!1)}var nM=B0;function iM(n,e,t,i,s){let r=di(Pg(n),Pg(e)),o=e-n,a=qi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?ar.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function jg(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Un((t=+s)*It))+"px"),[n,e,t]}function sM(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Xt(e[2]*It,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function $n(n,e,t){let i={mode:Ct(n.mode,1)},s=i.mode;function r(b,T,L,F){let X=T.valToPct(b);return F+L*(T.dir==-1?1-X:X)}function o(b,T,L,F){let X=T.valToPct(b);return F+L*(T.dir==-1?X:1-X)}function a(b,T,L,F){return T.ori==0?r(b,T,L,F):o(b,T,L,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=ki(hb);if(n.id!=null&&(c.id=n.id),Ei(c,n.class),n.title){let b=ki(pb,c);b.textContent=n.title}let u=Xi("canvas"),h=i.ctx=u.getContext("2d"),d=ki(mb,c);Ur("click",d,b=>{b.target===g&&(Jt!=co||rn!=uo)&&Yn.click(i,b)},!0);let f=i.under=ki(gb,d);d.appendChild(u);let g=i.over=ki(_b,d);n=Co(n);let y=+Ct(n.pxAlign,1),p=Zg(y);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let m=n.ms||.001,v=i.series=s==1?Qg(n.series||[],Gg,Yg,!1):QS(n.series||[null],qg),E=i.axes=Qg(n.axes||[],Vg,Wg,!0),S=i.scales={},R=i.bands=n.bands||[];R.forEach(b=>{b.fill=bt(b.fill||null),b.dir=Ct(b.dir,-1)});let C=s==2?v[1].facets[0].scale:v[0].scale,x={axes:As,series:_t},w=(n.drawOrder||["axes","series"]).map(b=>x[b]);function O(b){let T=b.distr==3?L=>Is(L>0?L:b.clamp(i,L,b.min,b.max,b.key)):b.distr==4?L=>Nd(L,b.asinh):b.distr==100?L=>b.fwd(L):L=>L;return L=>{let F=T(L),{_min:X,_max:J}=b,ae=J-X;return(F-X)/ae}}function I(b){let T=S[b];if(T==null){let L=(n.scales||Na)[b]||Na;if(L.from!=null){I(L.from);let F=Pn({},S[L.from],L,{key:b});F.valToPct=O(F),S[b]=F}else{T=S[b]=Pn({},b==C?A0:zS,L),T.key=b;let F=T.time,X=T.range,J=or(X);if((b!=C||s==2&&!F)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Ag:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Ag:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&wc(X))){let ae=X;X=(fe,ye,Fe)=>ye==null?Ao:xc(ye,Fe,ae)}T.range=bt(X||(F?jS:b==C?T.distr==3?tM:T.distr==4?nM:O0:T.distr==3?k0:T.distr==4?B0:eM)),T.auto=bt(J?!1:T.auto),T.clamp=bt(T.clamp||BS),T._min=T._max=null,T.valToPct=O(T)}}}I("x"),I("y"),s==1&&v.forEach(b=>{I(b.scale)}),E.forEach(b=>{I(b.scale)});for(let b in n.scales)I(b);let D=S[C],z=D.distr,G,N;D.ori==0?(Ei(c,db),G=r,N=o):(Ei(c,fb),G=o,N=r);let W={};for(let b in S){let T=S[b];(T.min!=null||T.max!=null)&&(W[b]={min:T.min,max:T.max},T.min=T.max=null)}let $=n.tzDate||(b=>new Date(Un(b/m))),H=n.fmtDate||tf,le=m==1?dS($):mS($),Y=kg($,Og(m==1?hS:pS,H)),j=zg($,Bg(_S,H)),ie=[],he=i.legend=Pn({},yS,n.legend),de=i.cursor=Pn({},TS,{drag:{y:s==2}},n.cursor),ee=he.show,me=de.show,ve=he.markers;he.idxs=ie,ve.width=bt(ve.width),ve.dash=bt(ve.dash),ve.stroke=bt(ve.stroke),ve.fill=bt(ve.fill);let Ce,Se,Ye,at=[],Xe=[],pt,ht=!1,rt={};if(he.live){let b=v[1]?v[1].values:null;ht=b!=null,pt=ht?b(i,1,0):{_:0};for(let T in pt)rt[T]=Zd}if(ee)if(Ce=Xi("table",Mb,c),Ye=Xi("tbody",null,Ce),he.mount(i,Ce),ht){Se=Xi("thead",null,Ce,Ye);let b=Xi("tr",null,Se);Xi("th",null,b);for(var sn in pt)Xi("th",pg,b).textContent=sn}else Ei(Ce,Eb),he.live&&Ei(Ce,wb);let Yt={show:!0},wn={show:!1};function zt(b,T){if(T==0&&(ht||!he.live||s==2))return Ao;let L=[],F=Xi("tr",Tb,Ye,Ye.childNodes[T]);Ei(F,b.class),b.show||Ei(F,Fr);let X=Xi("th",null,F);if(ve.show){let fe=ki(Ab,X);if(T>0){let ye=ve.width(i,T);ye&&(fe.style.border=ye+"px "+ve.dash(i,T)+" "+ve.stroke(i,T)),fe.style.background=ve.fill(i,T)}}let J=ki(pg,X);b.label instanceof HTMLElement?J.appendChild(b.label):J.textContent=b.label,T>0&&(ve.show||(J.style.color=b.width>0?ve.stroke(i,T):ve.fill(i,T)),Et("click",X,fe=>{if(de._lock)return;je(fe);let ye=v.indexOf(b);if((fe.ctrlKey||fe.metaKey)!=he.isolate){let Fe=v.some((Ue,ke)=>ke>0&&ke!=ye&&Ue.show);v.forEach((Ue,ke)=>{ke>0&&os(ke,Fe?ke==ye?Yt:wn:Yt,!0,Rn.setSeries)})}else os(ye,{show:!b.show},!0,Rn.setSeries)},!1),et&&Et(vg,X,fe=>{de._lock||(je(fe),os(v.indexOf(b),fo,!0,Rn.setSeries))},!1));for(var ae in pt){let fe=Xi("td",Cb,F);fe.textContent="--",L.push(fe)}return[F,L]}let zn=new Map;function Et(b,T,L,F=!0){let X=zn.get(T)||{},J=de.bind[b](i,T,L,F);J&&(Ur(b,T,X[b]=J),zn.set(T,X))}function Dn(b,T,L){let F=zn.get(T)||{};for(let X in F)(b==null||X==b)&&(Vd(X,T,F[X]),delete F[X]);b==null&&zn.delete(T)}let dn=0,En=0,B=0,Pe=0,Ke=0,lt=0,Me=Ke,Ht=lt,We=B,Ze=Pe,P=0,M=0,q=0,ue=0;i.bbox={};let oe=!1,_e=!1,xe=!1,te=!1,se=!1,pe=!1;function k(b,T,L){(L||b!=i.width||T!=i.height)&&re(b,T),dt(!1),xe=!0,_e=!0,Jn()}function re(b,T){i.width=dn=B=b,i.height=En=Pe=T,Ke=lt=0,be(),qe();let L=i.bbox;P=L.left=Dr(Ke*It,.5),M=L.top=Dr(lt*It,.5),q=L.width=Dr(B*It,.5),ue=L.height=Dr(Pe*It,.5)}let ne=3;function we(){let b=!1,T=0;for(;!b;){T++;let L=oo(T),F=rs(T);b=T==ne||L&&F,b||(re(i.width,i.height),_e=!0)}}function ge({width:b,height:T}){k(b,T)}i.setSize=ge;function be(){let b=!1,T=!1,L=!1,F=!1;E.forEach((X,J)=>{if(X.show&&X._show){let{side:ae,_size:fe}=X,ye=ae%2,Fe=X.label!=null?X.labelSize:0,Ue=fe+Fe;Ue>0&&(ye?(B-=Ue,ae==3?(Ke+=Ue,F=!0):L=!0):(Pe-=Ue,ae==0?(lt+=Ue,b=!0):T=!0))}}),is[0]=b,is[1]=L,is[2]=T,is[3]=F,B-=Gi[1]+Gi[3],Ke+=Gi[3],Pe-=Gi[2]+Gi[0],lt+=Gi[0]}function qe(){let b=Ke+B,T=lt+Pe,L=Ke,F=lt;function X(J,ae){switch(J){case 1:return b+=ae,b-ae;case 2:return T+=ae,T-ae;case 3:return L-=ae,L+ae;case 0:return F-=ae,F+ae}}E.forEach((J,ae)=>{if(J.show&&J._show){let fe=J.side;J._pos=X(fe,J._size),J.label!=null&&(J._lpos=X(fe,J.labelSize))}})}if(de.dataIdx==null){let b=de.hover,T=b.skip=new Set(b.skip??[]);T.add(void 0);let L=b.prox=bt(b.prox),F=b.bias??=0;de.dataIdx=(X,J,ae,fe)=>{if(J==0)return ae;let ye=ae,Fe=L(X,J,ae,fe)??Wt,Ue=Fe>=0&&Fe<Wt,ke=D.ori==0?B:Pe,ot=de.left,Rt=e[0],At=e[J];if(T.has(At[ae])){ye=null;let vt=null,Qe=null,$e;if(F==0||F==-1)for($e=ae;vt==null&&$e-- >0;)T.has(At[$e])||(vt=$e);if(F==0||F==1)for($e=ae;Qe==null&&$e++<At.length;)T.has(At[$e])||(Qe=$e);if(vt!=null||Qe!=null)if(Ue){let jt=vt==null?-1/0:G(Rt[vt],D,ke,0),mn=Qe==null?1/0:G(Rt[Qe],D,ke,0),Wn=ot-jt,Vt=mn-ot;Wn<=Vt?Wn<=Fe&&(ye=vt):Vt<=Fe&&(ye=Qe)}else ye=Qe==null?vt:vt==null?Qe:ae-vt<=Qe-ae?vt:Qe}else Ue&&On(ot-G(Rt[ae],D,ke,0))>Fe&&(ye=null);return ye}}let je=b=>{de.event=b};de.idxs=ie,de._lock=!1;let ce=de.points;ce.show=bt(ce.show),ce.size=bt(ce.size),ce.stroke=bt(ce.stroke),ce.width=bt(ce.width),ce.fill=bt(ce.fill);let Be=i.focus=Pn({},n.focus||{alpha:.3},de.focus),et=Be.prox>=0,Re=et&&ce.one,ut=[],Kt=[],ri=[];function ha(b,T){let L=ce.show(i,T);if(L instanceof HTMLElement)return Ei(L,Sb),Ei(L,b.class),fs(L,-10,-10,B,Pe),g.insertBefore(L,ut[T]),L}function io(b,T){if(s==1||T>0){let L=s==1&&S[b.scale].time,F=b.value;b.value=L?Dg(F)?zg($,Bg(F,H)):F||j:F||US,b.label=b.label||(L?CS:AS)}if(Re||T>0){b.width=b.width==null?1:b.width,b.paths=b.paths||KS||zb,b.fillTo=bt(b.fillTo||VS),b.pxAlign=+Ct(b.pxAlign,y),b.pxRound=Zg(b.pxAlign),b.stroke=bt(b.stroke||null),b.fill=bt(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let L=OS(di(1,b.width),1),F=b.points=Pn({},{size:L,width:di(1,L*.2),stroke:b.stroke,space:L*2,paths:JS,_stroke:null,_fill:null},b.points);F.show=bt(F.show),F.filter=bt(F.filter),F.fill=bt(F.fill),F.stroke=bt(F.stroke),F.paths=bt(F.paths),F.pxAlign=b.pxAlign}if(ee){let L=zt(b,T);at.splice(T,0,L[0]),Xe.splice(T,0,L[1]),he.values.push(null)}if(me){ie.splice(T,0,null);let L=null;Re?T==0&&(L=ha(b,T)):T>0&&(L=ha(b,T)),ut.splice(T,0,L),Kt.splice(T,0,0),ri.splice(T,0,0)}Hn("addSeries",T)}function Jh(b,T){T=T??v.length,b=s==1?Yd(b,T,Gg,Yg):Yd(b,T,{},qg),v.splice(T,0,b),io(v[T],T)}i.addSeries=Jh;function Rl(b){if(v.splice(b,1),ee){he.values.splice(b,1),Xe.splice(b,1);let T=at.splice(b,1)[0];Dn(null,T.firstChild),T.remove()}me&&(ie.splice(b,1),ut.splice(b,1)[0].remove(),Kt.splice(b,1),ri.splice(b,1)),Hn("delSeries",b)}i.delSeries=Rl;let is=[!1,!1,!1,!1];function ws(b,T){if(b._show=b.show,b.show){let L=b.side%2,F=S[b.scale];F==null&&(b.scale=L?v[1].scale:C,F=S[b.scale]);let X=F.time;b.size=bt(b.size),b.space=bt(b.space),b.rotate=bt(b.rotate),or(b.incrs)&&b.incrs.forEach(ae=>{!ar.has(ae)&&ar.set(ae,l0(ae))}),b.incrs=bt(b.incrs||(F.distr==2?lS:X?m==1?uS:fS:Nr)),b.splits=bt(b.splits||(X&&F.distr==1?le:F.distr==3?Hd:F.distr==4?IS:PS)),b.stroke=bt(b.stroke),b.grid.stroke=bt(b.grid.stroke),b.ticks.stroke=bt(b.ticks.stroke),b.border.stroke=bt(b.border.stroke);let J=b.values;b.values=or(J)&&!or(J[0])?bt(J):X?or(J)?kg($,Og(J,H)):Dg(J)?gS($,J):J||Y:J||RS,b.filter=bt(b.filter||(F.distr>=3&&F.log==10?NS:F.distr==3&&F.log==2?FS:o0)),b.font=jg(b.font),b.labelFont=jg(b.labelFont),b._size=b.size(i,null,T,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(is[T]=!0,b._el=ki(vb,d))}}function Es(b,T,L,F){let[X,J,ae,fe]=L,ye=T%2,Fe=0;return ye==0&&(fe||J)&&(Fe=T==0&&!X||T==2&&!ae?Un(Vg.size/3):0),ye==1&&(X||ae)&&(Fe=T==1&&!J||T==3&&!fe?Un(Wg.size/2):0),Fe}let da=i.padding=(n.padding||[Es,Es,Es,Es]).map(b=>bt(Ct(b,Es))),Gi=i._padding=da.map((b,T)=>b(i,T,is,0)),fn,yn=null,bn=null,ss=s==1?v[0].idxs:null,yi=null,qs=!1;function fa(b,T){if(e=b??[],i.data=i._data=e,s==2){fn=0;for(let L=1;L<v.length;L++)fn+=e[L][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),yi=e[0],fn=yi.length;let L=e;if(z==2){L=e.slice();let F=L[0]=Array(fn);for(let X=0;X<fn;X++)F[X]=X}i._data=e=L}if(dt(!0),Hn("setData"),z==2&&(xe=!0),T!==!1){let L=D;L.auto(i,qs)?pa():Zs(C,L.min,L.max),te=te||de.left>=0,pe=!0,Jn()}}i.setData=fa;function pa(){qs=!0;let b,T;s==1&&(fn>0?(yn=ss[0]=0,bn=ss[1]=fn-1,b=e[0][yn],T=e[0][bn],z==2?(b=yn,T=bn):b==T&&(z==3?[b,T]=Sc(b,b,D.log,!1):z==4?[b,T]=Jd(b,b,D.log,!1):D.time?T=b+Un(86400/m):[b,T]=xc(b,T,Qd,!0))):(yn=ss[0]=b=null,bn=ss[1]=T=null)),Zs(C,b,T)}let so,Ys,ro,A,V,Q,Z,K,Ee,Ie;function Te(b,T,L,F,X,J){b??=gg,L??=ef,F??="butt",X??=gg,J??="round",b!=so&&(h.strokeStyle=so=b),X!=Ys&&(h.fillStyle=Ys=X),T!=ro&&(h.lineWidth=ro=T),J!=V&&(h.lineJoin=V=J),F!=Q&&(h.lineCap=Q=F),L!=A&&h.setLineDash(A=L)}function De(b,T,L,F){T!=Ys&&(h.fillStyle=Ys=T),b!=Z&&(h.font=Z=b),L!=K&&(h.textAlign=K=L),F!=Ee&&(h.textBaseline=Ee=F)}function He(b,T,L,F,X=0){if(F.length>0&&b.auto(i,qs)&&(T==null||T.min==null)){let J=Ct(yn,0),ae=Ct(bn,F.length-1),fe=L.min==null?Nb(F,J,ae,X,b.distr==3):[L.min,L.max];b.min=Yi(b.min,L.min=fe[0]),b.max=di(b.max,L.max=fe[1])}}let nt={min:null,max:null};function gt(){for(let F in S){let X=S[F];W[F]==null&&(X.min==null||W[C]!=null&&X.auto(i,qs))&&(W[F]=nt)}for(let F in S){let X=S[F];W[F]==null&&X.from!=null&&W[X.from]!=null&&(W[F]=nt)}W[C]!=null&&dt(!0);let b={};for(let F in W){let X=W[F];if(X!=null){let J=b[F]=Co(S[F],Hb);if(X.min!=null)Pn(J,X);else if(F!=C||s==2)if(fn==0&&J.from==null){let ae=J.range(i,null,null,F);J.min=ae[0],J.max=ae[1]}else J.min=Wt,J.max=-Wt}}if(fn>0){v.forEach((F,X)=>{if(s==1){let J=F.scale,ae=W[J];if(ae==null)return;let fe=b[J];if(X==0){let ye=fe.range(i,fe.min,fe.max,J);fe.min=ye[0],fe.max=ye[1],yn=qi(fe.min,e[0]),bn=qi(fe.max,e[0]),bn-yn>1&&(e[0][yn]<fe.min&&yn++,e[0][bn]>fe.max&&bn--),F.min=yi[yn],F.max=yi[bn]}else F.show&&F.auto&&He(fe,ae,F,e[X],F.sorted);F.idxs[0]=yn,F.idxs[1]=bn}else if(X>0&&F.show&&F.auto){let[J,ae]=F.facets,fe=J.scale,ye=ae.scale,[Fe,Ue]=e[X],ke=b[fe],ot=b[ye];ke!=null&&He(ke,W[fe],J,Fe,J.sorted),ot!=null&&He(ot,W[ye],ae,Ue,ae.sorted),F.min=ae.min,F.max=ae.max}});for(let F in b){let X=b[F],J=W[F];if(X.from==null&&(J==null||J.min==null)){let ae=X.range(i,X.min==Wt?null:X.min,X.max==-Wt?null:X.max,F);X.min=ae[0],X.max=ae[1]}}}for(let F in b){let X=b[F];if(X.from!=null){let J=b[X.from];if(J.min==null)X.min=X.max=null;else{let ae=X.range(i,J.min,J.max,F);X.min=ae[0],X.max=ae[1]}}}let T={},L=!1;for(let F in b){let X=b[F],J=S[F];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let ae=J.distr;J._min=ae==3?Is(J.min):ae==4?Nd(J.min,J.asinh):ae==100?J.fwd(J.min):J.min,J._max=ae==3?Is(J.max):ae==4?Nd(J.max,J.asinh):ae==100?J.fwd(J.max):J.max,T[F]=L=!0}}if(L){v.forEach((F,X)=>{s==2?X>0&&T.y&&(F._paths=null):T[F.scale]&&(F._paths=null)});for(let F in T)xe=!0,Hn("setScale",F);me&&de.left>=0&&(te=pe=!0)}for(let F in W)W[F]=null}function ze(b){let T=Gd(yn-1,0,fn-1),L=Gd(bn+1,0,fn-1);for(;b[T]==null&&T>0;)T--;for(;b[L]==null&&L<fn-1;)L++;return[T,L]}function _t(){if(fn>0){let b=v.some(T=>T._focus)&&Ie!=Be.alpha;b&&(h.globalAlpha=Ie=Be.alpha),v.forEach((T,L)=>{if(L>0&&T.show&&(un(L,!1),un(L,!0),T._paths==null)){let F=Ie;Ie!=T.alpha&&(h.globalAlpha=Ie=T.alpha);let X=s==2?[0,e[L][0].length-1]:ze(e[L]);T._paths=T.paths(i,L,X[0],X[1]),Ie!=F&&(h.globalAlpha=Ie=F)}}),v.forEach((T,L)=>{if(L>0&&T.show){let F=Ie;Ie!=T.alpha&&(h.globalAlpha=Ie=T.alpha),T._paths!=null&&Ft(L,!1);{let X=T._paths!=null?T._paths.gaps:null,J=T.points.show(i,L,yn,bn,X),ae=T.points.filter(i,L,J,X);(J||ae)&&(T.points._paths=T.points.paths(i,L,yn,bn,ae),Ft(L,!0))}Ie!=F&&(h.globalAlpha=Ie=F),Hn("drawSeries",L)}}),b&&(h.globalAlpha=Ie=1)}}function un(b,T){let L=T?v[b].points:v[b];L._stroke=L.stroke(i,b),L._fill=L.fill(i,b)}function Ft(b,T){let L=T?v[b].points:v[b],{stroke:F,fill:X,clip:J,flags:ae,_stroke:fe=L._stroke,_fill:ye=L._fill,_width:Fe=L.width}=L._paths;Fe=Xt(Fe*It,3);let Ue=null,ke=Fe%2/2;T&&ye==null&&(ye=Fe>0?"#fff":fe);let ot=L.pxAlign==1&&ke>0;if(ot&&h.translate(ke,ke),!T){let Rt=P-Fe/2,At=M-Fe/2,vt=q+Fe,Qe=ue+Fe;Ue=new Path2D,Ue.rect(Rt,At,vt,Qe)}T?Oe(fe,Fe,L.dash,L.cap,ye,F,X,ae,J):Ut(b,fe,Fe,L.dash,L.cap,ye,F,X,ae,Ue,J),ot&&h.translate(-ke,-ke)}function Ut(b,T,L,F,X,J,ae,fe,ye,Fe,Ue){let ke=!1;ye!=0&&R.forEach((ot,Rt)=>{if(ot.series[0]==b){let At=v[ot.series[1]],vt=e[ot.series[1]],Qe=(At._paths||Na).band;or(Qe)&&(Qe=ot.dir==1?Qe[0]:Qe[1]);let $e,jt=null;At.show&&Qe&&Ub(vt,yn,bn)?(jt=ot.fill(i,Rt)||J,$e=At._paths.clip):Qe=null,Oe(T,L,F,X,jt,ae,fe,ye,Fe,Ue,$e,Qe),ke=!0}}),ke||Oe(T,L,F,X,J,ae,fe,ye,Fe,Ue)}let Nn=Ro|Xd;function Oe(b,T,L,F,X,J,ae,fe,ye,Fe,Ue,ke){Te(b,T,L,F,X),(ye||Fe||ke)&&(h.save(),ye&&h.clip(ye),Fe&&h.clip(Fe)),ke?(fe&Nn)==Nn?(h.clip(ke),Ue&&h.clip(Ue),yt(X,ae),Tn(b,J,T)):fe&Xd?(yt(X,ae),h.clip(ke),Tn(b,J,T)):fe&Ro&&(h.save(),h.clip(ke),Ue&&h.clip(Ue),yt(X,ae),h.restore(),Tn(b,J,T)):(yt(X,ae),Tn(b,J,T)),(ye||Fe||ke)&&h.restore()}function Tn(b,T,L){L>0&&(T instanceof Map?T.forEach((F,X)=>{h.strokeStyle=so=X,h.stroke(F)}):T!=null&&b&&h.stroke(T))}function yt(b,T){T instanceof Map?T.forEach((L,F)=>{h.fillStyle=Ys=F,h.fill(L)}):T!=null&&b&&h.fill(T)}function Ts(b,T,L,F){let X=E[b],J;if(F<=0)J=[0,0];else{let ae=X._space=X.space(i,b,T,L,F),fe=X._incrs=X.incrs(i,b,T,L,F,ae);J=iM(T,L,fe,F,ae)}return X._found=J}function An(b,T,L,F,X,J,ae,fe,ye,Fe){let Ue=ae%2/2;y==1&&h.translate(Ue,Ue),Te(fe,ae,ye,Fe,fe),h.beginPath();let ke,ot,Rt,At,vt=X+(F==0||F==3?-J:J);L==0?(ot=X,At=vt):(ke=X,Rt=vt);for(let Qe=0;Qe<b.length;Qe++)T[Qe]!=null&&(L==0?ke=Rt=b[Qe]:ot=At=b[Qe],h.moveTo(ke,ot),h.lineTo(Rt,At));h.stroke(),y==1&&h.translate(-Ue,-Ue)}function oo(b){let T=!0;return E.forEach((L,F)=>{if(!L.show)return;let X=S[L.scale];if(X.min==null){L._show&&(T=!1,L._show=!1,dt(!1));return}else L._show||(T=!1,L._show=!0,dt(!1));let J=L.side,ae=J%2,{min:fe,max:ye}=X,[Fe,Ue]=Ts(F,fe,ye,ae==0?B:Pe);if(Ue==0)return;let ke=X.distr==2,ot=L._splits=L.splits(i,F,fe,ye,Fe,Ue,ke),Rt=X.distr==2?ot.map($e=>yi[$e]):ot,At=X.distr==2?yi[ot[1]]-yi[ot[0]]:Fe,vt=L._values=L.values(i,L.filter(i,Rt,F,Ue,At),F,Ue,At);L._rotate=J==2?L.rotate(i,vt,F,Ue):0;let Qe=L._size;L._size=Bi(L.size(i,vt,F,b)),Qe!=null&&L._size!=Qe&&(T=!1)}),T}function rs(b){let T=!0;return da.forEach((L,F)=>{let X=L(i,F,is,b);X!=Gi[F]&&(T=!1),Gi[F]=X}),T}function As(){for(let b=0;b<E.length;b++){let T=E[b];if(!T.show||!T._show)continue;let L=T.side,F=L%2,X,J,ae=T.stroke(i,b),fe=L==0||L==3?-1:1,[ye,Fe]=T._found;if(T.label!=null){let li=T.labelGap*fe,Mi=Un((T._lpos+li)*It);De(T.labelFont[0],ae,"center",L==2?"top":mg),h.save(),F==1?(X=J=0,h.translate(Mi,Un(M+ue/2)),h.rotate((L==3?-_c:_c)/2)):(X=Un(P+q/2),J=Mi);let Ar=s0(T.label)?T.label(i,b,ye,Fe):T.label;h.fillText(Ar,X,J),h.restore()}if(Fe==0)continue;let Ue=S[T.scale],ke=F==0?q:ue,ot=F==0?P:M,Rt=T._splits,At=Ue.distr==2?Rt.map(li=>yi[li]):Rt,vt=Ue.distr==2?yi[Rt[1]]-yi[Rt[0]]:ye,Qe=T.ticks,$e=T.border,jt=Qe.show?Qe.size:0,mn=Un(jt*It),Wn=Un((T.alignTo==2?T._size-jt-T.gap:T.gap)*It),Vt=T._rotate*-_c/180,gn=p(T._pos*It),bi=(mn+Wn)*fe,ai=gn+bi;J=F==0?ai:0,X=F==1?ai:0;let Ni=T.font[0],Hi=T.align==1?Mo:T.align==2?Id:Vt>0?Mo:Vt<0?Id:F==0?"center":L==3?Id:Mo,ls=Vt||F==1?"middle":L==2?"top":mg;De(Ni,ae,Hi,ls);let Si=T.font[1]*T.lineGap,Fi=Rt.map(li=>p(a(li,Ue,ke,ot))),Wi=T._values;for(let li=0;li<Wi.length;li++){let Mi=Wi[li];if(Mi!=null){F==0?X=Fi[li]:J=Fi[li],Mi=""+Mi;let Ar=Mi.indexOf(`
`)==-1?[Mi]:Mi.split(/\n/gm);for(let ci=0;ci<Ar.length;ci++){let tm=Ar[ci];Vt?(h.save(),h.translate(X,J+ci*Si),h.rotate(Vt),h.fillText(tm,0,0),h.restore()):h.fillText(tm,X,J+ci*Si)}}}Qe.show&&An(Fi,Qe.filter(i,At,b,Fe,vt),F,L,gn,mn,Xt(Qe.width*It,3),Qe.stroke(i,b),Qe.dash,Qe.cap);let cs=T.grid;cs.show&&An(Fi,cs.filter(i,At,b,Fe,vt),F,F==0?2:1,F==0?M:P,F==0?ue:q,Xt(cs.width*It,3),cs.stroke(i,b),cs.dash,cs.cap),$e.show&&An([gn],[1],F==0?1:0,F==0?1:2,F==1?M:P,F==1?ue:q,Xt($e.width*It,3),$e.stroke(i,b),$e.dash,$e.cap)}Hn("drawAxes")}function dt(b){v.forEach((T,L)=>{L>0&&(T._paths=null,b&&(s==1?(T.min=null,T.max=null):T.facets.forEach(F=>{F.min=null,F.max=null})))})}let pn=!1,oi=!1,Ot=[];function Cn(){oi=!1;for(let b=0;b<Ot.length;b++)Hn(...Ot[b]);Ot.length=0}function Jn(){pn||(Kb(Op),pn=!0)}function Pl(b,T=!1){pn=!0,oi=T,b(i),Op(),T&&Ot.length>0&&queueMicrotask(Cn)}i.batch=Pl;function Op(){if(oe&&(gt(),oe=!1),xe&&(we(),xe=!1),_e){if(tn(f,Mo,Ke),tn(f,"top",lt),tn(f,Pa,B),tn(f,Ia,Pe),tn(g,Mo,Ke),tn(g,"top",lt),tn(g,Pa,B),tn(g,Ia,Pe),tn(d,Pa,dn),tn(d,Ia,En),u.width=Un(dn*It),u.height=Un(En*It),E.forEach(({_el:b,_show:T,_size:L,_pos:F,side:X})=>{if(b!=null)if(T){let J=X===3||X===0?L:0,ae=X%2==1;tn(b,ae?"left":"top",F-J),tn(b,ae?"width":"height",L),tn(b,ae?"top":"left",ae?lt:Ke),tn(b,ae?"height":"width",ae?Pe:B),zd(b,Fr)}else Ei(b,Fr)}),so=Ys=ro=V=Q=Z=K=Ee=A=null,Ie=1,_a(!0),Ke!=Me||lt!=Ht||B!=We||Pe!=Ze){dt(!1);let b=B/We,T=Pe/Ze;if(me&&!te&&de.left>=0){de.left*=b,de.top*=T,ao&&fs(ao,Un(de.left),0,B,Pe),lo&&fs(lo,0,Un(de.top),B,Pe);for(let L=0;L<ut.length;L++){let F=ut[L];F!=null&&(Kt[L]*=b,ri[L]*=T,fs(F,Bi(Kt[L]),Bi(ri[L]),B,Pe))}}if(Qt.show&&!se&&Qt.left>=0&&Qt.width>0){Qt.left*=b,Qt.width*=b,Qt.top*=T,Qt.height*=T;for(let L in id)tn(ho,L,Qt[L])}Me=Ke,Ht=lt,We=B,Ze=Pe}Hn("setSize"),_e=!1}dn>0&&En>0&&(h.clearRect(0,0,u.width,u.height),Hn("drawClear"),w.forEach(b=>b()),Hn("draw")),Qt.show&&se&&(Il(Qt),se=!1),me&&te&&(Tr(null,!0,!1),te=!1),he.show&&he.live&&pe&&(td(),pe=!1),l||(l=!0,i.status=1,Hn("ready")),qs=!1,pn=!1}i.redraw=(b,T)=>{xe=T||!1,b!==!1?Zs(C,D.min,D.max):Jn()};function Qh(b,T){let L=S[b];if(L.from==null){if(fn==0){let F=L.range(i,T.min,T.max,b);T.min=F[0],T.max=F[1]}if(T.min>T.max){let F=T.min;T.min=T.max,T.max=F}if(fn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;b==C&&L.distr==2&&fn>0&&(T.min=qi(T.min,e[0]),T.max=qi(T.max,e[0]),T.min==T.max&&T.max++),W[b]=T,oe=!0,Jn()}}i.setScale=Qh;let jh,ed,ao,lo,kp,Bp,co,uo,zp,Vp,Jt,rn,$s=!1,Yn=de.drag,Vn=Yn.x,Gn=Yn.y;me&&(de.x&&(jh=ki(yb,g)),de.y&&(ed=ki(bb,g)),D.ori==0?(ao=jh,lo=ed):(ao=ed,lo=jh),Jt=de.left,rn=de.top);let Qt=i.select=Pn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),ho=Qt.show?ki(xb,Qt.over?g:f):null;function Il(b,T){if(Qt.show){for(let L in b)Qt[L]=b[L],L in id&&tn(ho,L,b[L]);T!==!1&&Hn("setSelect")}}i.setSelect=Il;function Gx(b){if(v[b].show)ee&&zd(at[b],Fr);else if(ee&&Ei(at[b],Fr),me){let L=Re?ut[0]:ut[b];L!=null&&fs(L,-10,-10,B,Pe)}}function Zs(b,T,L){Qh(b,{min:T,max:L})}function os(b,T,L,F){T.focus!=null&&Yx(b),T.show!=null&&v.forEach((X,J)=>{J>0&&(b==J||b==null)&&(X.show=T.show,Gx(J),s==2?(Zs(X.facets[0].scale,null,null),Zs(X.facets[1].scale,null,null)):Zs(X.scale,null,null),Jn())}),L!==!1&&Hn("setSeries",b,T),F&&va("setSeries",i,b,T)}i.setSeries=os;function Hx(b,T){Pn(R[b],T)}function Wx(b,T){b.fill=bt(b.fill||null),b.dir=Ct(b.dir,-1),T=T??R.length,R.splice(T,0,b)}function Xx(b){b==null?R.length=0:R.splice(b,1)}i.addBand=Wx,i.setBand=Hx,i.delBand=Xx;function qx(b,T){v[b].alpha=T,me&&ut[b]!=null&&(ut[b].style.opacity=T),ee&&at[b]&&(at[b].style.opacity=T)}let Cs,Ks,Er,fo={focus:!0};function Yx(b){if(b!=Er){let T=b==null,L=Be.alpha!=1;v.forEach((F,X)=>{if(s==1||X>0){let J=T||X==0||X==b;F._focus=T?null:J,L&&qx(X,J?1:Be.alpha)}}),Er=b,L&&Jn()}}ee&&et&&Et(xg,Ce,b=>{de._lock||(je(b),Er!=null&&os(null,fo,!0,Rn.setSeries))});function as(b,T,L){let F=S[T];L&&(b=b/It-(F.ori==1?lt:Ke));let X=B;F.ori==1&&(X=Pe,b=X-b),F.dir==-1&&(b=X-b);let J=F._min,ae=F._max,fe=b/X,ye=J+(ae-J)*fe,Fe=F.distr;return Fe==3?To(10,ye):Fe==4?kb(ye,F.asinh):Fe==100?F.bwd(ye):ye}function $x(b,T){let L=as(b,C,T);return qi(L,e[0],yn,bn)}i.valToIdx=b=>qi(b,e[0]),i.posToIdx=$x,i.posToVal=as,i.valToPos=(b,T,L)=>S[T].ori==0?r(b,S[T],L?q:B,L?P:0):o(b,S[T],L?ue:Pe,L?M:0),i.setCursor=(b,T,L)=>{Jt=b.left,rn=b.top,Tr(null,T,L)};function Gp(b,T){tn(ho,Mo,Qt.left=b),tn(ho,Pa,Qt.width=T)}function Hp(b,T){tn(ho,"top",Qt.top=b),tn(ho,Ia,Qt.height=T)}let ma=D.ori==0?Gp:Hp,ga=D.ori==1?Gp:Hp;function Zx(){if(ee&&he.live)for(let b=s==2?1:0;b<v.length;b++){if(b==0&&ht)continue;let T=he.values[b],L=0;for(let F in T)Xe[b][L++].firstChild.nodeValue=T[F]}}function td(b,T){if(b!=null&&(b.idxs?b.idxs.forEach((L,F)=>{ie[F]=L}):Gb(b.idx)||ie.fill(b.idx),he.idx=ie[0]),ee&&he.live){for(let L=0;L<v.length;L++)(L>0||s==1&&!ht)&&Kx(L,ie[L]);Zx()}pe=!1,T!==!1&&Hn("setLegend")}i.setLegend=td;function Kx(b,T){let L=v[b],F=b==0&&z==2?yi:e[b],X;ht?X=L.values(i,b,T)??rt:(X=L.value(i,T==null?null:F[T],b,T),X=X==null?rt:{_:X}),he.values[b]=X}function Tr(b,T,L){zp=Jt,Vp=rn,[Jt,rn]=de.move(i,Jt,rn),de.left=Jt,de.top=rn,me&&(ao&&fs(ao,Un(Jt),0,B,Pe),lo&&fs(lo,0,Un(rn),B,Pe));let F,X=yn>bn;Cs=Wt,Ks=null;let J=D.ori==0?B:Pe,ae=D.ori==1?B:Pe;if(Jt<0||fn==0||X){F=de.idx=null;for(let fe=0;fe<v.length;fe++){let ye=ut[fe];ye!=null&&fs(ye,-10,-10,B,Pe)}et&&os(null,fo,!0,b==null&&Rn.setSeries),he.live&&(ie.fill(F),pe=!0)}else{let fe,ye,Fe;s==1&&(fe=D.ori==0?Jt:rn,ye=as(fe,C),F=de.idx=qi(ye,e[0],yn,bn),Fe=G(e[0][F],D,J,0));let Ue=-10,ke=-10,ot=0,Rt=0,At=!0,vt="",Qe="";for(let $e=s==2?1:0;$e<v.length;$e++){let jt=v[$e],mn=ie[$e],Wn=mn==null?null:s==1?e[$e][mn]:e[$e][1][mn],Vt=de.dataIdx(i,$e,F,ye),gn=Vt==null?null:s==1?e[$e][Vt]:e[$e][1][Vt];if(pe=pe||gn!=Wn||Vt!=mn,ie[$e]=Vt,$e>0&&jt.show){let bi=Vt==null?-10:Vt==F?Fe:G(s==1?e[0][Vt]:e[$e][0][Vt],D,J,0),ai=gn==null?-10:N(gn,s==1?S[jt.scale]:S[jt.facets[1].scale],ae,0);if(et&&gn!=null){let Ni=D.ori==1?Jt:rn,Hi=On(Be.dist(i,$e,Vt,ai,Ni));if(Hi<Cs){let ls=Be.bias;if(ls!=0){let Si=as(Ni,jt.scale),Fi=gn>=0?1:-1,Wi=Si>=0?1:-1;Wi==Fi&&(Wi==1?ls==1?gn>=Si:gn<=Si:ls==1?gn<=Si:gn>=Si)&&(Cs=Hi,Ks=$e)}else Cs=Hi,Ks=$e}}if(pe||Re){let Ni,Hi;D.ori==0?(Ni=bi,Hi=ai):(Ni=ai,Hi=bi);let ls,Si,Fi,Wi,cs,li,Mi=!0,Ar=ce.bbox;if(Ar!=null){Mi=!1;let ci=Ar(i,$e);Fi=ci.left,Wi=ci.top,ls=ci.width,Si=ci.height}else Fi=Ni,Wi=Hi,ls=Si=ce.size(i,$e);if(li=ce.fill(i,$e),cs=ce.stroke(i,$e),Re)$e==Ks&&Cs<=Be.prox&&(Ue=Fi,ke=Wi,ot=ls,Rt=Si,At=Mi,vt=li,Qe=cs);else{let ci=ut[$e];ci!=null&&(Kt[$e]=Fi,ri[$e]=Wi,Tg(ci,ls,Si,Mi),wg(ci,li,cs),fs(ci,Bi(Fi),Bi(Wi),B,Pe))}}}}if(Re){let $e=Be.prox,jt=Er==null?Cs<=$e:Cs>$e||Ks!=Er;if(pe||jt){let mn=ut[0];mn!=null&&(Kt[0]=Ue,ri[0]=ke,Tg(mn,ot,Rt,At),wg(mn,vt,Qe),fs(mn,Bi(Ue),Bi(ke),B,Pe))}}}if(Qt.show&&$s)if(b!=null){let[fe,ye]=Rn.scales,[Fe,Ue]=Rn.match,[ke,ot]=b.cursor.sync.scales,Rt=b.cursor.drag;if(Vn=Rt._x,Gn=Rt._y,Vn||Gn){let{left:At,top:vt,width:Qe,height:$e}=b.select,jt=b.scales[ke].ori,mn=b.posToVal,Wn,Vt,gn,bi,ai,Ni=fe!=null&&Fe(fe,ke),Hi=ye!=null&&Ue(ye,ot);Ni&&Vn?(jt==0?(Wn=At,Vt=Qe):(Wn=vt,Vt=$e),gn=S[fe],bi=G(mn(Wn,ke),gn,J,0),ai=G(mn(Wn+Vt,ke),gn,J,0),ma(Yi(bi,ai),On(ai-bi))):ma(0,J),Hi&&Gn?(jt==1?(Wn=At,Vt=Qe):(Wn=vt,Vt=$e),gn=S[ye],bi=N(mn(Wn,ot),gn,ae,0),ai=N(mn(Wn+Vt,ot),gn,ae,0),ga(Yi(bi,ai),On(ai-bi))):ga(0,ae)}else sd()}else{let fe=On(zp-kp),ye=On(Vp-Bp);if(D.ori==1){let ot=fe;fe=ye,ye=ot}Vn=Yn.x&&fe>=Yn.dist,Gn=Yn.y&&ye>=Yn.dist;let Fe=Yn.uni;Fe!=null?Vn&&Gn&&(Vn=fe>=Fe,Gn=ye>=Fe,!Vn&&!Gn&&(ye>fe?Gn=!0:Vn=!0)):Yn.x&&Yn.y&&(Vn||Gn)&&(Vn=Gn=!0);let Ue,ke;Vn&&(D.ori==0?(Ue=co,ke=Jt):(Ue=uo,ke=rn),ma(Yi(Ue,ke),On(ke-Ue)),Gn||ga(0,ae)),Gn&&(D.ori==1?(Ue=co,ke=Jt):(Ue=uo,ke=rn),ga(Yi(Ue,ke),On(ke-Ue)),Vn||ma(0,J)),!Vn&&!Gn&&(ma(0,0),ga(0,0))}if(Yn._x=Vn,Yn._y=Gn,b==null){if(L){if(em!=null){let[fe,ye]=Rn.scales;Rn.values[0]=fe!=null?as(D.ori==0?Jt:rn,fe):null,Rn.values[1]=ye!=null?as(D.ori==1?Jt:rn,ye):null}va(Ld,i,Jt,rn,B,Pe,F)}if(et){let fe=L&&Rn.setSeries,ye=Be.prox;Er==null?Cs<=ye&&os(Ks,fo,!0,fe):Cs>ye?os(null,fo,!0,fe):Ks!=Er&&os(Ks,fo,!0,fe)}}pe&&(he.idx=F,td()),T!==!1&&Hn("setCursor")}let Js=null;Object.defineProperty(i,"rect",{get(){return Js==null&&_a(!1),Js}});function _a(b=!1){b?Js=null:(Js=g.getBoundingClientRect(),Hn("syncRect",Js))}function Wp(b,T,L,F,X,J,ae){de._lock||$s&&b!=null&&b.movementX==0&&b.movementY==0||(nd(b,T,L,F,X,J,ae,!1,b!=null),b!=null?Tr(null,!0,!0):Tr(T,!0,!1))}function nd(b,T,L,F,X,J,ae,fe,ye){if(Js==null&&_a(!1),je(b),b!=null)L=b.clientX-Js.left,F=b.clientY-Js.top;else{if(L<0||F<0){Jt=-10,rn=-10;return}let[Fe,Ue]=Rn.scales,ke=T.cursor.sync,[ot,Rt]=ke.values,[At,vt]=ke.scales,[Qe,$e]=Rn.match,jt=T.axes[0].side%2==1,mn=D.ori==0?B:Pe,Wn=D.ori==1?B:Pe,Vt=jt?J:X,gn=jt?X:J,bi=jt?F:L,ai=jt?L:F;if(At!=null?L=Qe(Fe,At)?a(ot,S[Fe],mn,0):-10:L=mn*(bi/Vt),vt!=null?F=$e(Ue,vt)?a(Rt,S[Ue],Wn,0):-10:F=Wn*(ai/gn),D.ori==1){let Ni=L;L=F,F=Ni}}ye&&(T==null||T.cursor.event.type==Ld)&&((L<=1||L>=B-1)&&(L=Dr(L,B)),(F<=1||F>=Pe-1)&&(F=Dr(F,Pe))),fe?(kp=L,Bp=F,[co,uo]=de.move(i,L,F)):(Jt=L,rn=F)}let id={width:0,height:0,left:0,top:0};function sd(){Il(id,!1)}let Xp,qp,Yp,$p;function Zp(b,T,L,F,X,J,ae){$s=!0,Vn=Gn=Yn._x=Yn._y=!1,nd(b,T,L,F,X,J,ae,!0,!1),b!=null&&(Et(Dd,kd,Kp,!1),va(_g,i,co,uo,B,Pe,null));let{left:fe,top:ye,width:Fe,height:Ue}=Qt;Xp=fe,qp=ye,Yp=Fe,$p=Ue}function Kp(b,T,L,F,X,J,ae){$s=Yn._x=Yn._y=!1,nd(b,T,L,F,X,J,ae,!1,!0);let{left:fe,top:ye,width:Fe,height:Ue}=Qt,ke=Fe>0||Ue>0,ot=Xp!=fe||qp!=ye||Yp!=Fe||$p!=Ue;if(ke&&ot&&Il(Qt),Yn.setScale&&ke&&ot){let Rt=fe,At=Fe,vt=ye,Qe=Ue;if(D.ori==1&&(Rt=ye,At=Ue,vt=fe,Qe=Fe),Vn&&Zs(C,as(Rt,C),as(Rt+At,C)),Gn)for(let $e in S){let jt=S[$e];$e!=C&&jt.from==null&&jt.min!=Wt&&Zs($e,as(vt+Qe,$e),as(vt,$e))}sd()}else de.lock&&(de._lock=!de._lock,Tr(T,!0,b!=null));b!=null&&(Dn(Dd,kd),va(Dd,i,Jt,rn,B,Pe,null))}function Jx(b,T,L,F,X,J,ae){if(de._lock)return;je(b);let fe=$s;if($s){let ye=!0,Fe=!0,Ue=10,ke,ot;D.ori==0?(ke=Vn,ot=Gn):(ke=Gn,ot=Vn),ke&&ot&&(ye=Jt<=Ue||Jt>=B-Ue,Fe=rn<=Ue||rn>=Pe-Ue),ke&&ye&&(Jt=Jt<co?0:B),ot&&Fe&&(rn=rn<uo?0:Pe),Tr(null,!0,!0),$s=!1}Jt=-10,rn=-10,ie.fill(null),Tr(null,!0,!0),fe&&($s=fe)}function Jp(b,T,L,F,X,J,ae){de._lock||(je(b),pa(),sd(),b!=null&&va(yg,i,Jt,rn,B,Pe,null))}function Qp(){E.forEach(sM),k(i.width,i.height,!0)}Ur(vc,Eo,Qp);let po={};po.mousedown=Zp,po.mousemove=Wp,po.mouseup=Kp,po.dblclick=Jp,po.setSeries=(b,T,L,F)=>{let X=Rn.match[2];L=X(i,T,L),L!=-1&&os(L,F,!0,!1)},me&&(Et(_g,g,Zp),Et(Ld,g,Wp),Et(vg,g,b=>{je(b),_a(!1)}),Et(xg,g,Jx),Et(yg,g,Jp),qd.add(i),i.syncRect=_a);let Ll=i.hooks=n.hooks||{};function Hn(b,T,L){oi?Ot.push([b,T,L]):b in Ll&&Ll[b].forEach(F=>{F.call(null,i,T,L)})}(n.plugins||[]).forEach(b=>{for(let T in b.hooks)Ll[T]=(Ll[T]||[]).concat(b.hooks[T])});let jp=(b,T,L)=>L,Rn=Pn({key:null,setSeries:!1,filters:{pub:Ig,sub:Ig},scales:[C,v[1]?v[1].scale:null],match:[Lg,Lg,jp],values:[null,null]},de.sync);Rn.match.length==2&&Rn.match.push(jp),de.sync=Rn;let em=Rn.key,rd=C0(em);function va(b,T,L,F,X,J,ae){Rn.filters.pub(b,T,L,F,X,J,ae)&&rd.pub(b,T,L,F,X,J,ae)}rd.sub(i);function Qx(b,T,L,F,X,J,ae){Rn.filters.sub(b,T,L,F,X,J,ae)&&po[b](null,T,L,F,X,J,ae)}i.pub=Qx;function jx(){rd.unsub(i),qd.delete(i),zn.clear(),Vd(vc,Eo,Qp),c.remove(),Ce?.remove(),Hn("destroy")}i.destroy=jx;function od(){Hn("init",n,e),fa(e||n.data,!1),W[C]?Qh(C,W[C]):pa(),se=Qt.show&&(Qt.width>0||Qt.height>0),te=pe=!0,k(n.width,n.height)}return v.forEach(io),E.forEach(ws),t?t instanceof HTMLElement?(t.appendChild(c),od()):t(i,od):od(),i}$n.assign=Pn;$n.fmtNum=jd;$n.rangeNum=xc;$n.rangeLog=Sc;$n.rangeAsinh=Jd;$n.orient=kr;$n.pxRatio=It;$n.join=Zb;$n.fmtDate=tf,$n.tzDate=oS;$n.sync=C0;{$n.addGap=GS,$n.clipGaps=Ec;let n=$n.paths={points:N0};n.linear=U0,n.stepped=XS,n.bars=qS,n.spline=$S}var rM=350;function oM(n){return JSON.stringify({...n,pose:null})}var Rc=class extends Bt{constructor(t){super(new Map);this.studio=t;t.document.subscribe(()=>this.later()),t.connection.subscribe(()=>this.later())}studio;timer=0;running=null;isWanted=!1;want(t){this.isWanted=t,this.later()}later(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>{this.follow()},rM)}async follow(){this.running?.abort();let{studio:t}=this,i=t.document.get().oaks.filter(o=>!o.isHidden&&t.hasDepth(o.state));if(!this.isWanted||t.connection.get()!=="open")return;let s=new AbortController;this.running=s;let r=this.get();[...r.keys()].some(o=>!i.some(a=>a.key===o))&&this.set(new Map([...r].filter(([o])=>i.some(a=>a.key===o))));for(let o of i){let a=oM(o.state);if(this.get().get(o.key)?.key===a)continue;let l=await this.measure(a,o.state,s.signal);if(s.signal.aborted)return;this.set(new Map(this.get()).set(o.key,l))}}async measure(t,i,s){try{return{key:t,curve:await hn.accuracy(i,s),error:null}}catch(r){return{key:t,curve:null,error:r instanceof Error?r.message:String(r)}}}};var aM=13,lM=.85;function z0(){return _(en,{title:"Accuracy over distance",testId:"accuracy",children:_(cM,{})})}function cM(){let{studio:n}=Ve(),e=Tt(null);e.current??=new Rc(n);let t=e.current;Gt(()=>(t.want(!0),()=>t.want(!1)),[t]);let i=Ae(t),{oaks:s,selected:r}=Ae(n.document),o=Ae(n.display),a=Tt(null),l=Tt(null),c=Tt(null);Gt(()=>{if(a.current)return l.current?.destroy(),l.current=hM(a.current,s,i,i.get(r)?.curve?.bands??[],c),()=>{l.current?.destroy(),l.current=null}},[i,r,s.map(({key:d,state:f})=>d+f.model).join(),o.theme,o.showRight]),Gt(()=>n.probe.subscribe(()=>{c.current=n.probe.get()?.trueM??null,l.current?.redraw(!1)}),[n]);let u=[...i.values()].find(({error:d})=>d!==null)?.error,h=[...i.values()].every(({curve:d})=>d===null);return _(xt,{children:[_("div",{ref:a,class:"plot"}),u&&_("p",{class:"problem",role:"alert",children:u}),h&&!u&&_("p",{class:"hint",children:"Measuring…"}),!h&&_("p",{class:"hint",children:"Median error at a flat target. Shaded: what the maker specifies."})]})}function uM(n){let e=[...new Set(n.flatMap(({distancesM:i})=>i))].sort((i,s)=>i-s),t=n.map(i=>{let s=new Map(i.distancesM.map((r,o)=>[r,i.errorPercent[o]??null]));return e.map(r=>s.has(r)?s.get(r):void 0)});return[e,...t]}function hM(n,e,t,i,s){let r=e.flatMap((g,y)=>{let p=t.get(g.key)?.curve;return p?[{oak:g,index:y,curve:p}]:[]});if(r.length===0)return null;let o=getComputedStyle(document.documentElement),a=Number.parseFloat(o.fontSize),l=g=>o.getPropertyValue(g).trim(),c={stroke:l("--muted"),grid:{stroke:l("--line"),width:1},ticks:{stroke:l("--line"),width:1},font:`${lM*a}px system-ui`,size:2.6*a},u=r.flatMap(({curve:g})=>g.errorPercent.filter(y=>y!==null)),h=Math.max(1,...u.map(Math.abs),...i.map(({percent:g})=>g))*1.1,d=Math.min(0,...u)*1.1,f={width:Math.max(n.clientWidth,120),height:aM*a,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{size:5}},scales:{x:{time:!1},y:{range:[d,h]}},axes:[{...c,values:(g,y)=>y.map(p=>`${p} m`)},{...c,size:3.2*a,values:(g,y)=>y.map(p=>`${Number(p.toFixed(2))} %`)}],series:[{},...r.map(({oak:g,index:y})=>({label:g.state.model,stroke:on(Qn(y)),width:2,points:{show:!1}}))],hooks:{drawClear:[g=>dM(g,i,l("--band"))],draw:[g=>fM(g,s.current)]}};return new $n(f,uM(r.map(({curve:g})=>g)),n)}function dM(n,e,t){let{ctx:i}=n;i.save(),i.beginPath(),i.rect(n.bbox.left,n.bbox.top,n.bbox.width,n.bbox.height),i.clip(),i.fillStyle=t;for(let{fromM:s,toM:r,percent:o}of e){let[a,l]=[n.valToPos(s,"x",!0),n.valToPos(r,"x",!0)],[c,u]=[n.valToPos(o,"y",!0),n.valToPos(-o,"y",!0)];i.fillRect(a,c,l-a,u-c)}i.restore()}function fM(n,e){let{ctx:t,bbox:i}=n,[s=0,r=0]=[n.scales.x?.min??0,n.scales.x?.max??0];if(e===null||e<s||e>r)return;let o=n.valToPos(e,"x",!0);t.save(),t.strokeStyle="#ff2d78",t.lineWidth=devicePixelRatio,t.beginPath(),t.moveTo(o,i.top),t.lineTo(o,i.top+i.height),t.stroke(),t.restore()}function Pc({index:n,model:e,isShort:t}){return _("span",{class:"column-name",children:[_("span",{class:"dot-small",style:{background:on(Qn(Math.max(n,0)))}}),_("span",{class:t?"sr-only":"",children:eg(e)})]})}var Ic=260,Do=90;function pM({counts:n,fromM:e,toM:t},i,s,r){let o=c=>(c-i)/(s-i)*Ic,a=(t-e)/n.length,l=n.flatMap((c,u)=>{let h=(Do-c/r*(Do-4)).toFixed(1);return[`${o(e+u*a).toFixed(1)},${h}`,`${o(e+(u+1)*a).toFixed(1)},${h}`]});return`M${o(e).toFixed(1)},${Do}L${l.join("L")}L${o(t).toFixed(1)},${Do}`}function V0(){let{studio:n}=Ve(),e=Ae(n.frames),{oaks:t}=Ae(n.document),i=t.flatMap((l,c)=>{let u=e.get(l.key)?.header.statistics.histogram,h=u?.counts.reduce((d,f)=>d+f,0)??0;return u&&h?[{oak:l,index:c,histogram:u}]:[]}),s=Math.min(...i.map(({histogram:l})=>l.fromM)),r=Math.max(...i.map(({histogram:l})=>l.toM)),o=Math.max(...i.flatMap(({histogram:l})=>l.counts)),a=(0-s)/(r-s)*Ic;return _(en,{title:"Errors, measured minus true",testId:"histogram",children:i.length===0?_("p",{class:"hint",children:"No pixel has a value."}):_("figure",{class:"chart",children:[_("svg",{viewBox:`0 0 ${Ic} ${Do}`,preserveAspectRatio:"none",role:"img","aria-label":"Histogram of the errors",children:[a>0&&a<Ic&&_("line",{class:"zero",x1:a,x2:a,y1:0,y2:Do}),i.map(({oak:l,index:c,histogram:u})=>_("path",{d:pM(u,s,r,o),fill:on(Qn(c)),"fill-opacity":i.length>1?.18:.4,stroke:on(Qn(c)),"vector-effect":"non-scaling-stroke"},l.key))]}),_("figcaption",{children:[_("span",{children:ir(s)}),_("span",{children:ir(r)})]})]})})}function G0(){return _(xt,{children:[_(mM,{}),_(vM,{}),_(xM,{}),_(V0,{}),_(z0,{}),_(yM,{})]})}function mM(){let{studio:n}=Ve(),e=Ae(n.probe),{reasons:t}=Ae(n.catalog),{oaks:i}=Ae(n.document),s=i.findIndex(({key:a})=>a===e?.oak),r=e?t.find(({code:a})=>a===e.reason):void 0,o=e?.reason===0;return _(en,{title:"Pixel",testId:"readout",children:[!e&&_("p",{class:"hint",children:"Move the mouse over an image."}),e&&_(xt,{children:[_("div",{class:`verdict ${o?"":"missing"}`,children:[_("span",{class:"swatch",style:{background:on(o?Qn(Math.max(s,0)):er(e.reason))}}),_("div",{children:[_("strong",{children:o?`${Aa(e.measuredM)}, ${ir(e.errorM)}`:vn(r?.name??"unknown")}),_("p",{children:o?i[s]?.state.model:r?.documentation})]})]}),_("dl",{class:"facts",children:[_("dt",{children:"Pixel"}),_("dd",{children:[e.pixel[0],", ",e.pixel[1]]}),_("dt",{children:"True depth"}),_("dd",{children:Aa(e.trueM)}),_("dt",{children:"Measured depth"}),_("dd",{children:Aa(e.measuredM)}),_("dt",{children:"Error"}),_("dd",{children:[ir(e.errorM),gM(e.errorM,e.trueM)]}),_("dt",{children:"Disparity"}),_("dd",{children:e.disparityPx===null?"–":`${e.disparityPx.toFixed(2)} px`}),_("dt",{"data-tip":"The distance to the next depth that the sensor can report",children:"Depth step"}),_("dd",{children:Aa(e.stepM===null?null:Math.abs(e.stepM))}),_("dt",{children:"Object"}),_("dd",{class:"path",children:e.object??"–"}),e.occluder&&_(xt,{children:[_("dt",{children:"Hidden by"}),_("dd",{class:"path",children:e.occluder})]})]})]})]})}function gM(n,e){return n===null||!e?"":` (${(100*n/e).toFixed(2)} %)`}var _M=["Left","Top","Right","Bottom"];function vM(){let{studio:n}=Ve(),e=Ae(n.frames),{oaks:t,region:i}=Ae(n.document),s=t.filter(({key:c})=>e.has(c)),r=i.every((c,u)=>c===tr[u]),o=(c,u,h)=>_("tr",{children:[_("th",{scope:"row","data-tip":u,children:c}),s.map(({key:d})=>_("td",{class:e.get(d)?.isPreview?"provisional":"",children:h(d)},d))]}),a=c=>e.get(c)?.header.statistics,l=(c,u)=>n.document.commit("region",h=>{let d=h.region.map((f,g)=>g===c?u/100:f);return d[0]<d[2]&&d[1]<d[3]?{...h,region:d}:h});return _(en,{title:r?"Whole image":"Rectangle",testId:"statistics",actions:!r&&_(Ge,{label:"Whole image",class:"text",onClick:()=>n.document.commit("region",c=>({...c,region:tr}))}),children:[_("div",{class:"scroll-x",children:_("table",{class:"numbers",children:[_("thead",{children:_("tr",{children:[_("td",{}),s.map(({key:c,state:u})=>_("th",{scope:"col","data-tip":u.model,children:_(Pc,{index:t.findIndex(h=>h.key===c),model:u.model,isShort:s.length>2})},c))]})}),_("tbody",{children:[o("Fill rate, %","The share of the pixels that show a surface and have a value",c=>sr(a(c)?.fillRate)),o("Median error, mm","Measured minus true",c=>rr(a(c)?.medianErrorM,!0)),o("Median |error|, mm","The median of the size of the error",c=>rr(a(c)?.medianAbsoluteErrorM)),o("Median |error|, %","The median of the size of the error, relative to the true depth",c=>a(c)?.medianAbsoluteErrorPercent?.toFixed(2)??"–"),o("95th percentile, mm","95 % of the errors are smaller than this",c=>rr(a(c)?.p95AbsoluteErrorM)),o("Pixels, thousands","Those that show a surface",c=>((a(c)?.pixels??0)/1e3).toFixed(0))]})]})}),r?_("p",{class:"hint",children:"Drag a rectangle on an image to measure a part of it."}):_("div",{class:"quad",children:_M.map((c,u)=>_(Mn,{label:c,value:(i[u]??0)*100,onChange:h=>l(u,h),step:1,digits:1,minimum:0,maximum:100,unit:"%"},c))}),r&&_(Ge,{label:"Rectangle…",class:"text",onClick:()=>n.document.commit("region",c=>({...c,region:[.25,.25,.75,.75]}))})]})}function xM(){let{studio:n}=Ve(),{reasons:e}=Ae(n.catalog),t=Ae(n.frames),{oaks:i}=Ae(n.document),s=i.flatMap(o=>{let a=t.get(o.key)?.header.statistics.reasons,l=a?.reduce((c,u)=>c+u,0)??0;return a&&l?[{oak:o,shares:a.map(c=>c/l)}]:[]}),r=e.filter(({code:o})=>o!==0&&s.some(({shares:a})=>(a[o]??0)>0));return _(en,{title:"Why pixels have no value",testId:"reasons",children:[r.length===0&&_("p",{class:"hint",children:s.length?"Every pixel has a value.":"–"}),s.map(({oak:o,shares:a})=>_("div",{class:"stack",role:"img","aria-label":`${o.state.model}: ${r.map(({code:l,name:c})=>`${vn(c)} ${Lr(a[l])}`).join(", ")}`,children:e.map(({code:l})=>a[l]?_("span",{style:{width:`${(a[l]??0)*100}%`,background:on(er(l))}},l):null)},o.key)),_("table",{class:"numbers",children:_("tbody",{children:r.map(({code:o,name:a,documentation:l})=>_("tr",{children:[_("th",{scope:"row","data-tip":l,children:[_("span",{class:"swatch",style:{background:on(er(o))}}),vn(a),", %"]}),s.map(({oak:c,shares:u})=>_("td",{children:sr(u[o]??0)},c.key))]},o))})})]})}function yM(){let{studio:n}=Ve(),e=Ae(n.frames),{oaks:t}=Ae(n.document),i=t.flatMap(({key:s,state:r})=>(e.get(s)?.header.findings??[]).map(o=>({key:s,state:r,finding:o})));return i.length===0?null:_(en,{title:`Remarks (${i.length})`,isOpen:!1,children:_("ul",{class:"findings",children:i.map(({key:s,state:r,finding:o},a)=>_("li",{class:o.level,children:[_("strong",{children:[r.model,", ",o.place]}),": ",o.message,o.remedy&&`; ${o.remedy}`]},`${s}${a}`))})})}var bM=6e3;function H0(){let{studio:n}=Ve(),e=Ae(n.notices),t=Ae(n.connection);return _("div",{class:"notices",role:"region","aria-label":"Messages","aria-live":"polite",children:[t==="lost"&&_("div",{class:"notice error","data-testid":"lost",children:_("p",{children:"No connection to the server. The page connects again as soon as it runs."})}),e.map(i=>_(SM,{notice:i,onClose:()=>n.dismiss(i.id)},i.id))]})}function SM({notice:n,onClose:e}){let t=n.level==="note"&&n.findings.length===0;return Gt(()=>{if(!t)return;let i=setTimeout(e,bM);return()=>clearTimeout(i)},[]),_("div",{class:`notice ${n.level}`,"data-testid":"notice",children:[_("div",{class:"notice-head",children:[_("p",{children:n.text}),_(Ge,{icon:"close",label:"Close",class:"small",onClick:e})]}),n.findings.length>0&&_("ul",{class:"findings",children:n.findings.map(({level:i,place:s,message:r,remedy:o},a)=>_("li",{class:i,children:[_("strong",{children:s}),": ",r,o&&`; ${o}`]},a))})]})}function W0(){let{studio:n}=Ve(),e=Ae(n.document),{oaks:t}=e,i=t.length>=Ea;return _(en,{title:"OAKs",actions:_(xt,{children:[_(MM,{isDisabled:i}),_(Ge,{icon:"copy",label:"Duplicate the selected OAK",onClick:()=>{let r=Fn(e);r&&n.document.commit("add",o=>Md(o,structuredClone(r.state)))},isDisabled:i,testId:"duplicate"})]}),children:[_("ul",{class:"oaks","data-testid":"oaks",children:t.map((r,o)=>_(wM,{oak:r,index:o,isLast:t.length===1},r.key))}),t.length>1&&_(Oi,{label:"Same pose for all",tip:"Moving one OAK moves all, to compare models at the same place",isOn:e.arePosesLinked,onChange:r=>n.document.commit("link poses",o=>({...o,arePosesLinked:r}))})]})}function X0({models:n,selected:e}){return[...new Set(n.map(i=>i.maker))].map(i=>_("optgroup",{label:i,children:n.filter(s=>s.maker===i).map(({name:s,depthSensors:r})=>{let o=r.length>0;return _("option",{value:s,selected:s===e,disabled:!o,children:o?s:`${s} (no depth)`},s)})},i))}function MM({isDisabled:n}){let{studio:e}=Ve(),{models:t}=Ae(e.catalog),i=s=>{let r=e.catalog.get(),o=_i(r,s),a=Fn(e.document.get());!o||!a||e.document.commit("add",l=>Md(l,Jl(o,a.state.pose)))};return _("select",{class:"add","aria-label":"Add an OAK at the same pose","data-tip":"Add an OAK at the same pose, to compare models","data-testid":"add-oak",disabled:n,value:"",onChange:s=>{i(s.currentTarget.value),s.currentTarget.value=""},children:[_("option",{value:"",children:"Add…"}),_(X0,{models:t})]})}function wM({oak:n,index:e,isLast:t}){let{studio:i}=Ve(),s=Ae(i.catalog),{selected:r}=Ae(i.document),o=Ae(i.rejections).get(n.key),a=r===n.key,l=()=>i.document.set({...i.document.get(),selected:n.key}),c=h=>{let d=_i(s,h);d&&i.document.commit("model",f=>nr({...f,selected:n.key},n.key,g=>Ql(g,d)))},u=()=>i.document.commit("hide",h=>({...h,oaks:h.oaks.map(d=>d.key===n.key?{...d,isHidden:!d.isHidden}:d)}));return _("li",{class:`oak ${a?"selected":""}`,children:[_("button",{type:"button",class:"dot","aria-label":`Select OAK ${e+1}, ${n.state.model}`,"aria-pressed":a,onClick:l,children:_("span",{style:{background:on(Qn(e))}})}),_("div",{class:"oak-main",onClick:l,children:[_("select",{"aria-label":`Model of OAK ${e+1}`,"data-testid":"model",value:n.state.model,onChange:h=>c(h.currentTarget.value),children:_(X0,{models:s.models,selected:n.state.model})}),_("span",{class:"detail",children:EM(n,s)}),o&&!a&&_("span",{class:"problem",role:"alert",children:o.error})]}),_(Ge,{icon:n.isHidden?"hidden":"eye",label:n.isHidden?"Show":"Hide",isOn:n.isHidden,onClick:u}),_(Ge,{icon:"close",label:"Remove",isDisabled:t,onClick:()=>i.document.commit("remove",h=>$m(h,n.key))})]})}function EM(n,e){let t=_i(e,n.state.model),i=ui(e,n.state);return t?i?`${i.kind==="tof"?"ToF":i.baselineM?`${(i.baselineM*1e3).toFixed(0)} mm`:"stereo"} · ${i.hfovDeg.toFixed(0)}° · ${n.state.engine}`:`${t.generation} · no depth sensor`:"The server does not know this model."}var M_=0,Vf=1,w_=2;var ul=1,E_=2,ia=3,xs=0,gi=1,ii=2,Zr=0,sa=1,Gf=2,Hf=3,Wf=4,T_=5;var Kr=100,A_=101,C_=102,R_=103,P_=104,I_=200,L_=201,D_=202,N_=203,Xf=204,qf=205,F_=206,U_=207,O_=208,k_=209,B_=210,z_=211,V_=212,G_=213,H_=214,lu=0,cu=1,uu=2,$o=3,hu=4,du=5,fu=6,pu=7,zu=0,W_=1,X_=2,ys=0,Yf=1,$f=2,Zf=3,Kf=4,Jf=5,Qf=6,jf=7;var ep=300,Jr=301,ra=302,Vu=303,Gu=304,mu=1e3,ms=1001,gu=1002,Ln=1003,q_=1004;var hl=1005;var mi=1006,Hu=1007;var Hs=1008;var Kn=1009,tp=1010,np=1011,Sr=1012,Wu=1013,es=1014,ts=1015,ns=1016,Xu=1017,qu=1018,Qr=1020,ip=35902,sp=35899,rp=1021,op=1022,Di=1023,zs=1026,Ws=1027,ap=1028,oa=1029,Mr=1030,Yu=1031;var $u=1033,dl=33776,fl=33777,pl=33778,ml=33779,Zu=35840,Ku=35841,Ju=35842,Qu=35843,ju=36196,eh=37492,th=37496,nh=37488,ih=37489,gl=37490,sh=37491,rh=37808,oh=37809,ah=37810,lh=37811,ch=37812,uh=37813,hh=37814,dh=37815,fh=37816,ph=37817,mh=37818,gh=37819,_h=37820,vh=37821,xh=36492,yh=36494,bh=36495,Sh=36283,Mh=36284,_l=36285,wh=36286;var Ga=2300,_u=2301,ru=2302,Lf=2303,Df=2400,Nf=2401,Ff=2402;var Y_=3200;var Eh=0,$_=1,Xs="",Pi="srgb",Ha="srgb-linear",Wa="linear",Dt="srgb";var ou=7680;var Z_=519,K_=512,J_=513,Q_=514,lp=515,j_=516,ev=517,cp=518,up=519,tv=35044;var vl="300 es",Vi=2e3,Zo=2001;function TM(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function AM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Xa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function nv(){let n=Xa("canvas");return n.style.display="block",n}var q0={},Ko=null;function hp(...n){let e="THREE."+n.shift();Ko?Ko("log",e,...n):console.log(e,...n)}function iv(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Je(...n){n=iv(n);let e="THREE."+n.shift();if(Ko)Ko("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function tt(...n){n=iv(n);let e="THREE."+n.shift();if(Ko)Ko("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Va(...n){let e=n.join(" ");e in q0||(q0[e]=!0,Je(...n))}function sv(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var rv={[lu]:lu,[uu]:fu,[hu]:hu,[$o]:du,[cu]:cu,[fu]:uu,[pu]:pu,[du]:$o},Ji=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},jn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var au=Math.PI/180,vu=180/Math.PI;function xl(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(jn[n&255]+jn[n>>8&255]+jn[n>>16&255]+jn[n>>24&255]+"-"+jn[e&255]+jn[e>>8&255]+"-"+jn[e>>16&15|64]+jn[e>>24&255]+"-"+jn[t&63|128]+jn[t>>8&255]+"-"+jn[t>>16&255]+jn[t>>24&255]+jn[i&255]+jn[i>>8&255]+jn[i>>16&255]+jn[i>>24&255]).toLowerCase()}function wt(n,e,t){return Math.max(e,Math.min(t,n))}function CM(n,e){return(n%e+e)%e}function cf(n,e,t){return(1-t)*n+t*e}function ov(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function dp(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function RM(n,e){if(e.constructor===Float32Array)return n;let t=dp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function PM(n,e){if(e.constructor===Float32Array)return n;let t=dp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var ct=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=wt(this.x,e.x,t.x),this.y=wt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=wt(this.x,e,t),this.y=wt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(wt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(wt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},$t=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(h!==y||l!==d||c!==f||u!==g){let p=l*d+c*f+u*g+h*y;p<0&&(d=-d,f=-f,g=-g,y=-y,p=-p);let m=1-a;if(p<.9995){let v=Math.acos(p),E=Math.sin(v);m=Math.sin(m*v)/E,a=Math.sin(a*v)/E,l=l*m+d*a,c=c*m+f*a,u=u*m+g*a,h=h*m+y*a}else{l=l*m+d*a,c=c*m+f*a,u=u*m+g*a,h=h*m+y*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*f-c*d,e[t+1]=l*g+u*d+c*h-a*f,e[t+2]=c*g+u*f+a*d-l*h,e[t+3]=u*g-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"YXZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"ZXY":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"ZYX":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"YZX":this._x=d*u*h+c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h-d*f*g;break;case"XZY":this._x=d*u*h-c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h+d*f*g;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(wt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Y0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Y0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=wt(this.x,e.x,t.x),this.y=wt(this.y,e.y,t.y),this.z=wt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=wt(this.x,e,t),this.y=wt(this.y,e,t),this.z=wt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(wt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return uf.copy(this).projectOnVector(e),this.sub(uf)}reflect(e){return this.sub(uf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(wt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},uf=new U,Y0=new $t,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],g=i[8],y=s[0],p=s[3],m=s[6],v=s[1],E=s[4],S=s[7],R=s[2],C=s[5],x=s[8];return r[0]=o*y+a*v+l*R,r[3]=o*p+a*E+l*C,r[6]=o*m+a*S+l*x,r[1]=c*y+u*v+h*R,r[4]=c*p+u*E+h*C,r[7]=c*m+u*S+h*x,r[2]=d*y+f*v+g*R,r[5]=d*p+f*E+g*C,r[8]=d*m+f*S+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,g=t*h+i*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=h*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=d*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=f*y,e[7]=(i*l-c*t)*y,e[8]=(o*t-i*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Va("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(hf.makeScale(e,t)),this}rotate(e){return Va("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(hf.makeRotation(-e)),this}translate(e,t){return Va("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(hf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},hf=new it,$0=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Z0=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function IM(){let n={enabled:!0,workingColorSpace:Ha,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=Bs(s.r),s.g=Bs(s.g),s.b=Bs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=Yo(s.r),s.g=Yo(s.g),s.b=Yo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Xs?Wa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ha]:{primaries:e,whitePoint:i,transfer:Wa,toXYZ:$0,fromXYZ:Z0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Pi},outputColorSpaceConfig:{drawingBufferColorSpace:Pi}},[Pi]:{primaries:e,whitePoint:i,transfer:Dt,toXYZ:$0,fromXYZ:Z0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Pi}}}),n}var St=IM();function Bs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Yo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var No,xu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{No===void 0&&(No=Xa("canvas")),No.width=e.width,No.height=e.height;let s=No.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=No}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Xa("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Bs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Bs(t[i]/255)*255):t[i]=Bs(t[i]);return{data:t,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},LM=0,Jo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:LM++}),this.uuid=xl(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(df(s[o].image)):r.push(df(s[o]))}else r=df(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function df(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?xu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var DM=0,ff=new U,vi=class n extends Ji{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=ms,s=ms,r=mi,o=Hs,a=Di,l=Kn,c=n.DEFAULT_ANISOTROPY,u=Xs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:DM++}),this.uuid=xl(),this.name="",this.source=new Jo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ct(0,0),this.repeat=new ct(1,1),this.center=new ct(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ff).x}get height(){return this.source.getSize(ff).y}get depth(){return this.source.getSize(ff).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ep)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case mu:e.x=e.x-Math.floor(e.x);break;case ms:e.x=e.x<0?0:1;break;case gu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case mu:e.y=e.y-Math.floor(e.y);break;case ms:e.y=e.y<0?0:1;break;case gu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};vi.DEFAULT_IMAGE=null;vi.DEFAULT_MAPPING=ep;vi.DEFAULT_ANISOTROPY=1;var an=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],g=l[9],y=l[2],p=l[6],m=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+y)<.1&&Math.abs(g+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,S=(f+1)/2,R=(m+1)/2,C=(u+d)/4,x=(h+y)/4,w=(g+p)/4;return E>S&&E>R?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=C/i,r=x/i):S>R?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=C/s,r=w/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=x/r,s=w/r),this.set(i,s,r,t),this}let v=Math.sqrt((p-g)*(p-g)+(h-y)*(h-y)+(d-u)*(d-u));return Math.abs(v)<.001&&(v=1),this.x=(p-g)/v,this.y=(h-y)/v,this.z=(d-u)/v,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=wt(this.x,e.x,t.x),this.y=wt(this.y,e.y,t.y),this.z=wt(this.z,e.z,t.z),this.w=wt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=wt(this.x,e,t),this.y=wt(this.y,e,t),this.z=wt(this.z,e,t),this.w=wt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(wt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},yu=class extends Ji{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:mi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new an(0,0,e,t),this.scissorTest=!1,this.viewport=new an(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new vi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:mi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Jo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ii=class extends yu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},qa=class extends vi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=ms,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var bu=class extends vi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=ms,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Mt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,d,f,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,d,f,g,y,p)}set(e,t,i,s,r,o,a,l,c,u,h,d,f,g,y,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=d,m[3]=f,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Fo.setFromMatrixColumn(e,0).length(),r=1/Fo.setFromMatrixColumn(e,1).length(),o=1/Fo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,g=a*u,y=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+g*c,t[5]=d-y*c,t[9]=-a*l,t[2]=y-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,g=c*u,y=c*h;t[0]=d+y*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-g,t[6]=y+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,g=c*u,y=c*h;t[0]=d-y*a,t[4]=-o*h,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*u,t[9]=y-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,g=a*u,y=a*h;t[0]=l*u,t[4]=g*c-f,t[8]=d*c+y,t[1]=l*h,t[5]=y*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*u,t[4]=y-d*h,t[8]=g*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+g,t[10]=d-y*h}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+y,t[5]=o*u,t[9]=f*h-g,t[2]=g*h-f,t[6]=a*u,t[10]=y*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(NM,e,FM)}lookAt(e,t,i){let s=this.elements;return Ci.subVectors(e,t),Ci.lengthSq()===0&&(Ci.z=1),Ci.normalize(),cr.crossVectors(i,Ci),cr.lengthSq()===0&&(Math.abs(i.z)===1?Ci.x+=1e-4:Ci.z+=1e-4,Ci.normalize(),cr.crossVectors(i,Ci)),cr.normalize(),Lc.crossVectors(Ci,cr),s[0]=cr.x,s[4]=Lc.x,s[8]=Ci.x,s[1]=cr.y,s[5]=Lc.y,s[9]=Ci.y,s[2]=cr.z,s[6]=Lc.z,s[10]=Ci.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],g=i[2],y=i[6],p=i[10],m=i[14],v=i[3],E=i[7],S=i[11],R=i[15],C=s[0],x=s[4],w=s[8],O=s[12],I=s[1],D=s[5],z=s[9],G=s[13],N=s[2],W=s[6],$=s[10],H=s[14],le=s[3],Y=s[7],j=s[11],ie=s[15];return r[0]=o*C+a*I+l*N+c*le,r[4]=o*x+a*D+l*W+c*Y,r[8]=o*w+a*z+l*$+c*j,r[12]=o*O+a*G+l*H+c*ie,r[1]=u*C+h*I+d*N+f*le,r[5]=u*x+h*D+d*W+f*Y,r[9]=u*w+h*z+d*$+f*j,r[13]=u*O+h*G+d*H+f*ie,r[2]=g*C+y*I+p*N+m*le,r[6]=g*x+y*D+p*W+m*Y,r[10]=g*w+y*z+p*$+m*j,r[14]=g*O+y*G+p*H+m*ie,r[3]=v*C+E*I+S*N+R*le,r[7]=v*x+E*D+S*W+R*Y,r[11]=v*w+E*z+S*$+R*j,r[15]=v*O+E*G+S*H+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],g=e[3],y=e[7],p=e[11],m=e[15],v=l*f-c*d,E=a*f-c*h,S=a*d-l*h,R=o*f-c*u,C=o*d-l*u,x=o*h-a*u;return t*(y*v-p*E+m*S)-i*(g*v-p*R+m*C)+s*(g*E-y*R+m*x)-r*(g*S-y*C+p*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],g=e[12],y=e[13],p=e[14],m=e[15],v=t*a-i*o,E=t*l-s*o,S=t*c-r*o,R=i*l-s*a,C=i*c-r*a,x=s*c-r*l,w=u*y-h*g,O=u*p-d*g,I=u*m-f*g,D=h*p-d*y,z=h*m-f*y,G=d*m-f*p,N=v*G-E*z+S*D+R*I-C*O+x*w;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*G-l*z+c*D)*W,e[1]=(s*z-i*G-r*D)*W,e[2]=(y*x-p*C+m*R)*W,e[3]=(d*C-h*x-f*R)*W,e[4]=(l*I-o*G-c*O)*W,e[5]=(t*G-s*I+r*O)*W,e[6]=(p*S-g*x-m*E)*W,e[7]=(u*x-d*S+f*E)*W,e[8]=(o*z-a*I+c*w)*W,e[9]=(i*I-t*z-r*w)*W,e[10]=(g*C-y*S+m*v)*W,e[11]=(h*S-u*C-f*v)*W,e[12]=(a*O-o*D-l*w)*W,e[13]=(t*D-i*O+s*w)*W,e[14]=(y*E-g*R-p*v)*W,e[15]=(u*R-h*E+d*v)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,g=r*h,y=o*u,p=o*h,m=a*h,v=l*c,E=l*u,S=l*h,R=i.x,C=i.y,x=i.z;return s[0]=(1-(y+m))*R,s[1]=(f+S)*R,s[2]=(g-E)*R,s[3]=0,s[4]=(f-S)*C,s[5]=(1-(d+m))*C,s[6]=(p+v)*C,s[7]=0,s[8]=(g+E)*x,s[9]=(p-v)*x,s[10]=(1-(d+y))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Fo.set(s[0],s[1],s[2]).length(),a=Fo.set(s[4],s[5],s[6]).length(),l=Fo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),$i.copy(this);let c=1/o,u=1/a,h=1/l;return $i.elements[0]*=c,$i.elements[1]*=c,$i.elements[2]*=c,$i.elements[4]*=u,$i.elements[5]*=u,$i.elements[6]*=u,$i.elements[8]*=h,$i.elements[9]*=h,$i.elements[10]*=h,t.setFromRotationMatrix($i),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Vi,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===Vi)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Zo)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Vi,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===Vi)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===Zo)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Fo=new U,$i=new Mt,NM=new U(0,0,0),FM=new U(1,1,1),cr=new U,Lc=new U,Ci=new U,K0=new Mt,J0=new $t,Qi=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-wt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(wt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-wt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(wt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return K0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(K0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return J0.setFromEuler(this),this.setFromQuaternion(J0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Qi.DEFAULT_ORDER="XYZ";var Qo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},UM=0,Q0=new U,Uo=new $t,Ds=new Mt,Dc=new U,Ua=new U,OM=new U,kM=new $t,j0=new U(1,0,0),e_=new U(0,1,0),t_=new U(0,0,1),n_={type:"added"},BM={type:"removed"},Oo={type:"childadded",child:null},pf={type:"childremoved",child:null},ln=class n extends Ji{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:UM++}),this.uuid=xl(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new U,t=new Qi,i=new $t,s=new U(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Mt},normalMatrix:{value:new it}}),this.matrix=new Mt,this.matrixWorld=new Mt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Qo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Uo.setFromAxisAngle(e,t),this.quaternion.multiply(Uo),this}rotateOnWorldAxis(e,t){return Uo.setFromAxisAngle(e,t),this.quaternion.premultiply(Uo),this}rotateX(e){return this.rotateOnAxis(j0,e)}rotateY(e){return this.rotateOnAxis(e_,e)}rotateZ(e){return this.rotateOnAxis(t_,e)}translateOnAxis(e,t){return Q0.copy(e).applyQuaternion(this.quaternion),this.position.add(Q0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(j0,e)}translateY(e){return this.translateOnAxis(e_,e)}translateZ(e){return this.translateOnAxis(t_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ds.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Dc.copy(e):Dc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ua.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ds.lookAt(Ua,Dc,this.up):Ds.lookAt(Dc,Ua,this.up),this.quaternion.setFromRotationMatrix(Ds),s&&(Ds.extractRotation(s.matrixWorld),Uo.setFromRotationMatrix(Ds),this.quaternion.premultiply(Uo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(n_),Oo.child=e,this.dispatchEvent(Oo),Oo.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(BM),pf.child=e,this.dispatchEvent(pf),pf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ds.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ds.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ds),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(n_),Oo.child=e,this.dispatchEvent(Oo),Oo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ua,e,OM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ua,kM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ln.DEFAULT_UP=new U(0,1,0);ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ti=class extends ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},zM={type:"move"},jo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ti,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ti,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ti,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=t.getJointPose(y,i),m=this._getHandJoint(c,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(zM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new ti;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},av={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ur={h:0,s:0,l:0},Nc={h:0,s:0,l:0};function mf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var st=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Pi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=i,St.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=St.workingColorSpace){if(e=CM(e,1),t=wt(t,0,1),i=wt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=mf(o,r,e+1/3),this.g=mf(o,r,e),this.b=mf(o,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=Pi){function i(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Pi){let i=av[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Bs(e.r),this.g=Bs(e.g),this.b=Bs(e.b),this}copyLinearToSRGB(e){return this.r=Yo(e.r),this.g=Yo(e.g),this.b=Yo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Pi){return St.workingToColorSpace(ei.copy(this),e),Math.round(wt(ei.r*255,0,255))*65536+Math.round(wt(ei.g*255,0,255))*256+Math.round(wt(ei.b*255,0,255))}getHexString(e=Pi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(ei.copy(this),t);let i=ei.r,s=ei.g,r=ei.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(ei.copy(this),t),e.r=ei.r,e.g=ei.g,e.b=ei.b,e}getStyle(e=Pi){St.workingToColorSpace(ei.copy(this),e);let t=ei.r,i=ei.g,s=ei.b;return e!==Pi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(ur),this.setHSL(ur.h+e,ur.s+t,ur.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(ur),e.getHSL(Nc);let i=cf(ur.h,Nc.h,t),s=cf(ur.s,Nc.s,t),r=cf(ur.l,Nc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ei=new st;st.NAMES=av;var Ya=class extends ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Qi,this.environmentIntensity=1,this.environmentRotation=new Qi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Zi=new U,Ns=new U,gf=new U,Fs=new U,ko=new U,Bo=new U,i_=new U,_f=new U,vf=new U,xf=new U,yf=new an,bf=new an,Sf=new an,ks=class n{constructor(e=new U,t=new U,i=new U){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Zi.subVectors(e,t),s.cross(Zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Zi.subVectors(s,t),Ns.subVectors(i,t),gf.subVectors(e,t);let o=Zi.dot(Zi),a=Zi.dot(Ns),l=Zi.dot(gf),c=Ns.dot(Ns),u=Ns.dot(gf),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,g=(o*u-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Fs)===null?!1:Fs.x>=0&&Fs.y>=0&&Fs.x+Fs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Fs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Fs.x),l.addScaledVector(o,Fs.y),l.addScaledVector(a,Fs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return yf.setScalar(0),bf.setScalar(0),Sf.setScalar(0),yf.fromBufferAttribute(e,t),bf.fromBufferAttribute(e,i),Sf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(yf,r.x),o.addScaledVector(bf,r.y),o.addScaledVector(Sf,r.z),o}static isFrontFacing(e,t,i,s){return Zi.subVectors(i,t),Ns.subVectors(e,t),Zi.cross(Ns).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Zi.subVectors(this.c,this.b),Ns.subVectors(this.a,this.b),Zi.cross(Ns).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;ko.subVectors(s,i),Bo.subVectors(r,i),_f.subVectors(e,i);let l=ko.dot(_f),c=Bo.dot(_f);if(l<=0&&c<=0)return t.copy(i);vf.subVectors(e,s);let u=ko.dot(vf),h=Bo.dot(vf);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(ko,o);xf.subVectors(e,r);let f=ko.dot(xf),g=Bo.dot(xf);if(g>=0&&f<=g)return t.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(Bo,a);let p=u*g-f*h;if(p<=0&&h-u>=0&&f-g>=0)return i_.subVectors(r,s),a=(h-u)/(h-u+(f-g)),t.copy(s).addScaledVector(i_,a);let m=1/(p+y+d);return o=y*m,a=d*m,t.copy(i).addScaledVector(ko,o).addScaledVector(Bo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},gs=class{constructor(e=new U(1/0,1/0,1/0),t=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ki.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ki.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ki.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ki):Ki.fromBufferAttribute(r,o),Ki.applyMatrix4(e.matrixWorld),this.expandByPoint(Ki);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Fc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Fc.copy(i.boundingBox)),Fc.applyMatrix4(e.matrixWorld),this.union(Fc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ki),Ki.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Oa),Uc.subVectors(this.max,Oa),zo.subVectors(e.a,Oa),Vo.subVectors(e.b,Oa),Go.subVectors(e.c,Oa),hr.subVectors(Vo,zo),dr.subVectors(Go,Vo),Br.subVectors(zo,Go);let t=[0,-hr.z,hr.y,0,-dr.z,dr.y,0,-Br.z,Br.y,hr.z,0,-hr.x,dr.z,0,-dr.x,Br.z,0,-Br.x,-hr.y,hr.x,0,-dr.y,dr.x,0,-Br.y,Br.x,0];return!Mf(t,zo,Vo,Go,Uc)||(t=[1,0,0,0,1,0,0,0,1],!Mf(t,zo,Vo,Go,Uc))?!1:(Oc.crossVectors(hr,dr),t=[Oc.x,Oc.y,Oc.z],Mf(t,zo,Vo,Go,Uc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ki).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ki).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Us[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Us[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Us[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Us[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Us[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Us[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Us[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Us[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Us),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Us=[new U,new U,new U,new U,new U,new U,new U,new U],Ki=new U,Fc=new gs,zo=new U,Vo=new U,Go=new U,hr=new U,dr=new U,Br=new U,Oa=new U,Uc=new U,Oc=new U,zr=new U;function Mf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){zr.fromArray(n,r);let a=s.x*Math.abs(zr.x)+s.y*Math.abs(zr.y)+s.z*Math.abs(zr.z),l=e.dot(zr),c=t.dot(zr),u=i.dot(zr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var In=new U,kc=new ct,VM=0,Zn=class extends Ji{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:VM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=tv,this.updateRanges=[],this.gpuType=ts,this.version=0,this._normalizationScale=e!==void 0?dp(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)kc.fromBufferAttribute(this,t),kc.applyMatrix3(e),this.setXY(t,kc.x,kc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.applyMatrix3(e),this.setXYZ(t,In.x,In.y,In.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.applyMatrix4(e),this.setXYZ(t,In.x,In.y,In.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.applyNormalMatrix(e),this.setXYZ(t,In.x,In.y,In.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.transformDirection(e),this.setXYZ(t,In.x,In.y,In.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):RM(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):PM(e,this.array)}};var $a=class extends Zn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Za=class extends Zn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var mt=class extends Zn{constructor(e,t,i){super(new Float32Array(e),t,i)}},GM=new gs,ka=new U,wf=new U,pr=class{constructor(e=new U,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):GM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ka.subVectors(e,this.center);let t=ka.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ka,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(wf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ka.copy(e.center).add(wf)),this.expandByPoint(ka.copy(e.center).sub(wf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},HM=0,zi=new Mt,Ef=new ln,Ho=new U,Ri=new gs,Ba=new gs,Xn=new U,Nt=class n extends Ji{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:HM++}),this.uuid=xl(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(TM(e)?Za:$a)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new it().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return zi.makeRotationFromQuaternion(e),this.applyMatrix4(zi),this}rotateX(e){return zi.makeRotationX(e),this.applyMatrix4(zi),this}rotateY(e){return zi.makeRotationY(e),this.applyMatrix4(zi),this}rotateZ(e){return zi.makeRotationZ(e),this.applyMatrix4(zi),this}translate(e,t,i){return zi.makeTranslation(e,t,i),this.applyMatrix4(zi),this}scale(e,t,i){return zi.makeScale(e,t,i),this.applyMatrix4(zi),this}lookAt(e){return Ef.lookAt(e),Ef.updateMatrix(),this.applyMatrix4(Ef.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ho).negate(),this.translate(Ho.x,Ho.y,Ho.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new mt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new gs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Ri.setFromBufferAttribute(r),this.morphTargetsRelative?(Xn.addVectors(this.boundingBox.min,Ri.min),this.boundingBox.expandByPoint(Xn),Xn.addVectors(this.boundingBox.max,Ri.max),this.boundingBox.expandByPoint(Xn)):(this.boundingBox.expandByPoint(Ri.min),this.boundingBox.expandByPoint(Ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new pr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(e){let i=this.boundingSphere.center;if(Ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ba.setFromBufferAttribute(a),this.morphTargetsRelative?(Xn.addVectors(Ri.min,Ba.min),Ri.expandByPoint(Xn),Xn.addVectors(Ri.max,Ba.max),Ri.expandByPoint(Xn)):(Ri.expandByPoint(Ba.min),Ri.expandByPoint(Ba.max))}Ri.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Xn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Xn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Xn.fromBufferAttribute(a,c),l&&(Ho.fromBufferAttribute(e,c),Xn.add(Ho)),s=Math.max(s,i.distanceToSquared(Xn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Zn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let O=0;O<i.count;O++)a[O]=new U,l[O]=new U;let u=new U,h=new U,d=new U,f=new ct,g=new ct,y=new ct,p=new U,m=new U;function v(O,I,D){c[O]=c[I]=c[D]=1,u.fromBufferAttribute(i,O),h.fromBufferAttribute(i,I),d.fromBufferAttribute(i,D),f.fromBufferAttribute(r,O),g.fromBufferAttribute(r,I),y.fromBufferAttribute(r,D),h.sub(u),d.sub(u),g.sub(f),y.sub(f);let z=1/(g.x*y.y-y.x*g.y);isFinite(z)&&(p.copy(h).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(z),m.copy(d).multiplyScalar(g.x).addScaledVector(h,-y.x).multiplyScalar(z),a[O].add(p),a[I].add(p),a[D].add(p),l[O].add(m),l[I].add(m),l[D].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let O=0,I=E.length;O<I;++O){let D=E[O],z=D.start,G=D.count;for(let N=z,W=z+G;N<W;N+=3)v(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new U,R=new U,C=new U,x=new U;function w(O){C.fromBufferAttribute(s,O),x.copy(C);let I=a[O];S.copy(I),S.sub(C.multiplyScalar(C.dot(I))).normalize(),R.crossVectors(x,I);let z=R.dot(l[O])<0?-1:1;o.setXYZW(O,S.x,S.y,S.z,z)}for(let O=0,I=i.count;O<I;++O)c[O]&&w(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Zn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new U,r=new U,o=new U,a=new U,l=new U,c=new U,u=new U,h=new U;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),y=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,p),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Xn.fromBufferAttribute(e,t),Xn.normalize(),e.setXYZ(t,Xn.x,Xn.y,Xn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,g=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*u;for(let m=0;m<u;m++)d[g++]=c[f++]}return new Zn(d,u,h)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Tf=new U,WM=new U,XM=new it,fi=class{constructor(e=new U(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Tf.subVectors(i,t).cross(WM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Tf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||XM.getNormalMatrix(e),s=this.coplanarPoint(Tf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},qM=0,_s=class extends Ji{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:qM++}),this.uuid=xl(),this.name="",this.type="Material",this.blending=sa,this.side=xs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Xf,this.blendDst=qf,this.blendEquation=Kr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new st(0,0,0),this.blendAlpha=0,this.depthFunc=$o,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Z_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ou,this.stencilZFail=ou,this.stencilZPass=ou,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new st().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new fi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new ct().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ct().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Os=new U,Af=new U,Bc=new U,zc=new U,Hr=class{constructor(e=new U,t=new U(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Os)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Os.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Os.copy(this.origin).addScaledVector(this.direction,t),Os.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Af.copy(e).add(t).multiplyScalar(.5),Bc.copy(t).sub(e).normalize(),zc.copy(this.origin).sub(Af);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Bc),a=zc.dot(this.direction),l=-zc.dot(Bc),c=zc.lengthSq(),u=Math.abs(1-o*o),h,d,f,g;if(u>0)if(h=o*l-a,d=o*a-l,g=r*u,h>=0)if(d>=-g)if(d<=g){let y=1/u;h*=y,d*=y,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-g?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=g?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Af).addScaledVector(Bc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Os.subVectors(e.center,this.origin);let i=Os.dot(this.direction),s=Os.dot(Os)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Os)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,y=t.y-o.y,p=t.z-o.z,m=i.x-o.x,v=i.y-o.y,E=i.z-o.z,S=Math.abs(l),R=Math.abs(c),C=Math.abs(u),x,w,O,I,D,z,G,N,W,$,H,le;if(S>=R&&S>=C?(O=l,z=h,W=g,le=m,l>=0?(x=c,w=u,I=d,D=f,G=y,N=p,$=v,H=E):(x=u,w=c,I=f,D=d,G=p,N=y,$=E,H=v)):R>=C?(O=c,z=d,W=y,le=v,c>=0?(x=u,w=l,I=f,D=h,G=p,N=g,$=E,H=m):(x=l,w=u,I=h,D=f,G=g,N=p,$=m,H=E)):(O=u,z=f,W=p,le=E,u>=0?(x=l,w=c,I=h,D=d,G=g,N=y,$=m,H=v):(x=c,w=l,I=d,D=h,G=y,N=g,$=v,H=m)),O===0)return null;let Y=x/O,j=w/O,ie=1/O,he=I-Y*z,de=D-j*z,ee=G-Y*W,me=N-j*W,ve=$-Y*le,Ce=H-j*le,Se=ve*me-Ce*ee,Ye=he*Ce-de*ve,at=ee*de-me*he;if(s){if(Se<0||Ye<0||at<0)return null}else if((Se<0||Ye<0||at<0)&&(Se>0||Ye>0||at>0))return null;let Xe=Se+Ye+at;if(Xe===0)return null;let pt=ie*(Se*z+Ye*W+at*le);return(Xe>0?pt<0:pt>0)?null:this.at(pt/Xe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ji=class extends _s{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new st(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Qi,this.combine=zu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},s_=new Mt,Vr=new Hr,Vc=new pr,r_=new U,Gc=new U,Hc=new U,Wc=new U,Cf=new U,Xc=new U,o_=new U,qc=new U,Le=class extends ln{constructor(e=new Nt,t=new ji){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Xc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Cf.fromBufferAttribute(h,e),o?Xc.addScaledVector(Cf,u):Xc.addScaledVector(Cf.sub(t),u))}t.add(Xc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Vc.copy(i.boundingSphere),Vc.applyMatrix4(r),Vr.copy(e.ray).recast(e.near),!(Vc.containsPoint(Vr.origin)===!1&&(Vr.intersectSphere(Vc,r_)===null||Vr.origin.distanceToSquared(r_)>(e.far-e.near)**2))&&(s_.copy(r).invert(),Vr.copy(e.ray).applyMatrix4(s_),!(i.boundingBox!==null&&Vr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Vr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],v=Math.max(p.start,f.start),E=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let S=v,R=E;S<R;S+=3){let C=a.getX(S),x=a.getX(S+1),w=a.getX(S+2);s=Yc(this,m,e,i,c,u,h,C,x,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let v=a.getX(p),E=a.getX(p+1),S=a.getX(p+2);s=Yc(this,o,e,i,c,u,h,v,E,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],v=Math.max(p.start,f.start),E=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let S=v,R=E;S<R;S+=3){let C=S,x=S+1,w=S+2;s=Yc(this,m,e,i,c,u,h,C,x,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let v=p,E=p+1,S=p+2;s=Yc(this,o,e,i,c,u,h,v,E,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function YM(n,e,t,i,s,r,o,a){let l;if(e.side===gi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===xs,a),l===null)return null;qc.copy(a),qc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(qc);return c<t.near||c>t.far?null:{distance:c,point:qc.clone(),object:n}}function Yc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Gc),n.getVertexPosition(l,Hc),n.getVertexPosition(c,Wc);let u=YM(n,e,t,i,Gc,Hc,Wc,o_);if(u){let h=new U;ks.getBarycoord(o_,Gc,Hc,Wc,h),s&&(u.uv=ks.getInterpolatedAttribute(s,a,l,c,h,new ct)),r&&(u.uv1=ks.getInterpolatedAttribute(r,a,l,c,h,new ct)),o&&(u.normal=ks.getInterpolatedAttribute(o,a,l,c,h,new U),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new U,materialIndex:0};ks.getNormal(Gc,Hc,Wc,d.normal),u.face=d,u.barycoord=h}return u}var Wr=class extends vi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Ln,u=Ln,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Gr=new pr,$M=new ct(.5,.5),$c=new U,mr=class{constructor(e=new fi,t=new fi,i=new fi,s=new fi,r=new fi,o=new fi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Vi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],g=r[8],y=r[9],p=r[10],m=r[11],v=r[12],E=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-o,f-u,m-g,R-v).normalize(),s[1].setComponents(c+o,f+u,m+g,R+v).normalize(),s[2].setComponents(c+a,f+h,m+y,R+E).normalize(),s[3].setComponents(c-a,f-h,m-y,R-E).normalize(),i)s[4].setComponents(l,d,p,S).normalize(),s[5].setComponents(c-l,f-d,m-p,R-S).normalize();else if(s[4].setComponents(c-l,f-d,m-p,R-S).normalize(),t===Vi)s[5].setComponents(c+l,f+d,m+p,R+S).normalize();else if(t===Zo)s[5].setComponents(l,d,p,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Gr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Gr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Gr)}intersectsSprite(e){Gr.center.set(0,0,0);let t=$M.distanceTo(e.center);return Gr.radius=.7071067811865476+t,Gr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Gr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if($c.x=s.normal.x>0?e.max.x:e.min.x,$c.y=s.normal.y>0?e.max.y:e.min.y,$c.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint($c)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},a_=new Mt,Su=class n{constructor(){this.coordinateSystem=Vi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];a_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new mr),i[s].setFromProjectionMatrix(a_,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new mr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var xi=class extends _s{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new st(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Mu=new U,wu=new U,l_=new Mt,za=new Hr,Zc=new pr,Rf=new U,c_=new U,ni=class extends ln{constructor(e=new Nt,t=new xi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Mu.fromBufferAttribute(t,s-1),wu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Mu.distanceTo(wu);e.setAttribute("lineDistance",new mt(i,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Zc.copy(i.boundingSphere),Zc.applyMatrix4(s),Zc.radius+=r,e.ray.intersectsSphere(Zc)===!1)return;l_.copy(s).invert(),za.copy(e.ray).applyMatrix4(l_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=u.getX(y),v=u.getX(y+1),E=Kc(this,e,za,l,m,v,y);E&&t.push(E)}if(this.isLineLoop){let y=u.getX(g-1),p=u.getX(f),m=Kc(this,e,za,l,y,p,g-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=Kc(this,e,za,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=Kc(this,e,za,l,g-1,f,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Kc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Mu.fromBufferAttribute(a,s),wu.fromBufferAttribute(a,r),t.distanceSqToSegment(Mu,wu,Rf,c_)>i)return;Rf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Rf);if(!(c<e.near||c>e.far))return{distance:c,point:c_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var u_=new U,h_=new U,gr=class extends ni{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)u_.fromBufferAttribute(t,s),h_.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+u_.distanceTo(h_);e.setAttribute("lineDistance",new mt(i,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Ka=class extends ni{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},ea=class extends _s{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new st(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},d_=new Mt,Uf=new Hr,Jc=new pr,Qc=new U,Xr=class extends ln{constructor(e=new Nt,t=new ea){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Jc.copy(i.boundingSphere),Jc.applyMatrix4(s),Jc.radius+=r,e.ray.intersectsSphere(Jc)===!1)return;d_.copy(s).invert(),Uf.copy(e.ray).applyMatrix4(d_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let g=d,y=f;g<y;g++){let p=c.getX(g);Qc.fromBufferAttribute(h,p),f_(Qc,p,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let g=d,y=f;g<y;g++)Qc.fromBufferAttribute(h,g),f_(Qc,g,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function f_(n,e,t,i,s,r,o){let a=Uf.distanceSqToPoint(n);if(a<t){let l=new U;Uf.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Ja=class extends vi{constructor(e=[],t=Jr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Vs=class extends vi{constructor(e,t,i=es,s,r,o,a=Ln,l=Ln,c,u=zs,h=1){if(u!==zs&&u!==Ws)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Jo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Qa=class extends Vs{constructor(e,t=es,i=Jr,s,r,o=Ln,a=Ln,l,c=zs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ja=class extends vi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Zt=class n extends Nt{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new mt(c,3)),this.setAttribute("normal",new mt(u,3)),this.setAttribute("uv",new mt(h,2));function g(y,p,m,v,E,S,R,C,x,w,O){let I=S/x,D=R/w,z=S/2,G=R/2,N=C/2,W=x+1,$=w+1,H=0,le=0,Y=new U;for(let j=0;j<$;j++){let ie=j*D-G;for(let he=0;he<W;he++){let de=he*I-z;Y[y]=de*v,Y[p]=ie*E,Y[m]=N,c.push(Y.x,Y.y,Y.z),Y[y]=0,Y[p]=0,Y[m]=C>0?1:-1,u.push(Y.x,Y.y,Y.z),h.push(he/x),h.push(1-j/w),H+=1}}for(let j=0;j<w;j++)for(let ie=0;ie<x;ie++){let he=d+ie+W*j,de=d+ie+W*(j+1),ee=d+(ie+1)+W*(j+1),me=d+(ie+1)+W*j;l.push(he,de,me),l.push(de,ee,me),le+=6}a.addGroup(f,le,O),f+=le,d+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var qn=class n extends Nt{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],g=0,y=[],p=i/2,m=0;v(),o===!1&&(e>0&&E(!0),t>0&&E(!1)),this.setIndex(u),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(d,3)),this.setAttribute("uv",new mt(f,2));function v(){let S=new U,R=new U,C=0,x=(t-e)/i;for(let w=0;w<=r;w++){let O=[],I=w/r,D=I*(t-e)+e;for(let z=0;z<=s;z++){let G=z/s,N=G*l+a,W=Math.sin(N),$=Math.cos(N);R.x=D*W,R.y=-I*i+p,R.z=D*$,h.push(R.x,R.y,R.z),S.set(W,x,$).normalize(),d.push(S.x,S.y,S.z),f.push(G,1-I),O.push(g++)}y.push(O)}for(let w=0;w<s;w++)for(let O=0;O<r;O++){let I=y[O][w],D=y[O+1][w],z=y[O+1][w+1],G=y[O][w+1];(e>0||O!==0)&&(u.push(I,D,G),C+=3),(t>0||O!==r-1)&&(u.push(D,z,G),C+=3)}c.addGroup(m,C,0),m+=C}function E(S){let R=g,C=new ct,x=new U,w=0,O=S===!0?e:t,I=S===!0?1:-1;for(let z=1;z<=s;z++)h.push(0,p*I,0),d.push(0,I,0),f.push(.5,.5),g++;let D=g;for(let z=0;z<=s;z++){let N=z/s*l+a,W=Math.cos(N),$=Math.sin(N);x.x=O*$,x.y=p*I,x.z=O*W,h.push(x.x,x.y,x.z),d.push(0,I,0),C.x=W*.5+.5,C.y=$*.5*I+.5,f.push(C.x,C.y),g++}for(let z=0;z<s;z++){let G=R+z,N=D+z;S===!0?u.push(N,N+1,G):u.push(N+1,N,G),w+=3}c.addGroup(m,w,S===!0?1:2),m+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Eu=class n extends Nt{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new mt(r,3)),this.setAttribute("normal",new mt(r.slice(),3)),this.setAttribute("uv",new mt(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(v){let E=new U,S=new U,R=new U;for(let C=0;C<t.length;C+=3)f(t[C+0],E),f(t[C+1],S),f(t[C+2],R),l(E,S,R,v)}function l(v,E,S,R){let C=R+1,x=[];for(let w=0;w<=C;w++){x[w]=[];let O=v.clone().lerp(S,w/C),I=E.clone().lerp(S,w/C),D=C-w;for(let z=0;z<=D;z++)z===0&&w===C?x[w][z]=O:x[w][z]=O.clone().lerp(I,z/D)}for(let w=0;w<C;w++)for(let O=0;O<2*(C-w)-1;O++){let I=Math.floor(O/2);O%2===0?(d(x[w][I+1]),d(x[w+1][I]),d(x[w][I])):(d(x[w][I+1]),d(x[w+1][I+1]),d(x[w+1][I]))}}function c(v){let E=new U;for(let S=0;S<r.length;S+=3)E.x=r[S+0],E.y=r[S+1],E.z=r[S+2],E.normalize().multiplyScalar(v),r[S+0]=E.x,r[S+1]=E.y,r[S+2]=E.z}function u(){let v=new U;for(let E=0;E<r.length;E+=3){v.x=r[E+0],v.y=r[E+1],v.z=r[E+2];let S=p(v)/2/Math.PI+.5,R=m(v)/Math.PI+.5;o.push(S,1-R)}g(),h()}function h(){for(let v=0;v<o.length;v+=6){let E=o[v+0],S=o[v+2],R=o[v+4],C=Math.max(E,S,R),x=Math.min(E,S,R);C>.9&&x<.1&&(E<.2&&(o[v+0]+=1),S<.2&&(o[v+2]+=1),R<.2&&(o[v+4]+=1))}}function d(v){r.push(v.x,v.y,v.z)}function f(v,E){let S=v*3;E.x=e[S+0],E.y=e[S+1],E.z=e[S+2]}function g(){let v=new U,E=new U,S=new U,R=new U,C=new ct,x=new ct,w=new ct;for(let O=0,I=0;O<r.length;O+=9,I+=6){v.set(r[O+0],r[O+1],r[O+2]),E.set(r[O+3],r[O+4],r[O+5]),S.set(r[O+6],r[O+7],r[O+8]),C.set(o[I+0],o[I+1]),x.set(o[I+2],o[I+3]),w.set(o[I+4],o[I+5]),R.copy(v).add(E).add(S).divideScalar(3);let D=p(R);y(C,I+0,v,D),y(x,I+2,E,D),y(w,I+4,S,D)}}function y(v,E,S,R){R<0&&v.x===1&&(o[E]=v.x-1),S.x===0&&S.z===0&&(o[E]=R/2/Math.PI+.5)}function p(v){return Math.atan2(v.z,-v.x)}function m(v){return Math.atan2(-v.y,Math.sqrt(v.x*v.x+v.z*v.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.vertices,e.indices,e.radius,e.detail)}};var jc=new U,eu=new U,Pf=new U,tu=new ks,el=class extends Nt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(au*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),d=new Map,f=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:y,b:p,c:m}=tu;if(y.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),tu.getNormal(Pf),h[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,h[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,h[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let v=0;v<3;v++){let E=(v+1)%3,S=h[v],R=h[E],C=tu[u[v]],x=tu[u[E]],w=`${S}_${R}`,O=`${R}_${S}`,I=d.get(O);I?(Pf.dot(I.normal)<=r&&(f.push(C.x,C.y,C.z),f.push(x.x,x.y,x.z)),d.set(O,null)):d.has(w)||d.set(w,{index0:c[v],index1:c[E],normal:Pf.clone()})}}for(let g of d.values())if(g){let{index0:y,index1:p}=g;jc.fromBufferAttribute(a,y),eu.fromBufferAttribute(a,p),f.push(jc.x,jc.y,jc.z),f.push(eu.x,eu.y,eu.z)}this.setAttribute("position",new mt(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var _r=class n extends Eu{constructor(e=1,t=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new n(e.radius,e.detail)}},qr=class n extends Nt{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],g=[],y=[],p=[];for(let m=0;m<u;m++){let v=m*d-o;for(let E=0;E<c;E++){let S=E*h-r;g.push(S,-v,0),y.push(0,0,1),p.push(E/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let E=v+c*m,S=v+c*(m+1),R=v+1+c*(m+1),C=v+1+c*m;f.push(E,S,C),f.push(S,R,C)}this.setIndex(f),this.setAttribute("position",new mt(g,3)),this.setAttribute("normal",new mt(y,3)),this.setAttribute("uv",new mt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Yr=class n extends Nt{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new U,d=new U,f=[],g=[],y=[],p=[];for(let m=0;m<=i;m++){let v=[],E=m/i,S=o+E*a,R=e*Math.cos(S),C=Math.sqrt(e*e-R*R),x=0;m===0&&o===0?x=.5/t:m===i&&l===Math.PI&&(x=-.5/t);for(let w=0;w<=t;w++){let O=w/t,I=s+O*r;h.x=-C*Math.cos(I),h.y=R,h.z=C*Math.sin(I),g.push(h.x,h.y,h.z),d.copy(h).normalize(),y.push(d.x,d.y,d.z),p.push(O+x,1-E),v.push(c++)}u.push(v)}for(let m=0;m<i;m++)for(let v=0;v<t;v++){let E=u[m][v+1],S=u[m][v],R=u[m+1][v],C=u[m+1][v+1];(m!==0||o>0)&&f.push(E,S,C),(m!==i-1||l<Math.PI)&&f.push(S,R,C)}this.setIndex(f),this.setAttribute("position",new mt(g,3)),this.setAttribute("normal",new mt(y,3)),this.setAttribute("uv",new mt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Gs=class n extends Nt{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new U,f=new U,g=new U;for(let y=0;y<=i;y++){let p=o+y/i*a;for(let m=0;m<=s;m++){let v=m/s*r;f.x=(e+t*Math.cos(p))*Math.cos(v),f.y=(e+t*Math.cos(p))*Math.sin(v),f.z=t*Math.sin(p),c.push(f.x,f.y,f.z),d.x=e*Math.cos(v),d.y=e*Math.sin(v),g.subVectors(f,d).normalize(),u.push(g.x,g.y,g.z),h.push(m/s),h.push(y/i)}}for(let y=1;y<=i;y++)for(let p=1;p<=s;p++){let m=(s+1)*y+p-1,v=(s+1)*(y-1)+p-1,E=(s+1)*(y-1)+p,S=(s+1)*y+p;l.push(m,v,S),l.push(v,E,S)}this.setIndex(l),this.setAttribute("position",new mt(c,3)),this.setAttribute("normal",new mt(u,3)),this.setAttribute("uv",new mt(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function jr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(p_(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(p_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function si(n){let e={};for(let t=0;t<n.length;t++){let i=jr(n[t]);for(let s in i)e[s]=i[s]}return e}function p_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function ZM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function fp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var lv={clone:jr,merge:si},KM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,JM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,vs=class extends _s{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=KM,this.fragmentShader=JM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=jr(e.uniforms),this.uniformsGroups=ZM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new st().setHex(s.value);break;case"v2":this.uniforms[i].value=new ct().fromArray(s.value);break;case"v3":this.uniforms[i].value=new U().fromArray(s.value);break;case"v4":this.uniforms[i].value=new an().fromArray(s.value);break;case"m3":this.uniforms[i].value=new it().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Mt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},ta=class extends vs{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var $r=class extends _s{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new st(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new st(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Eh,this.normalScale=new ct(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Qi,this.combine=zu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Tu=class extends _s{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Y_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Au=class extends _s{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Wo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function nu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var vr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Cu=class extends vr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Df,endingEnd:Df}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Nf:r=e,a=2*t-i;break;case Ff:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Nf:o=e,l=2*i-t;break;case Ff:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(i-t)/(s-t),y=g*g,p=y*g,m=-d*p+2*d*y-d*g,v=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*g+1,E=(-1-f)*p+(1.5+f)*y+.5*g,S=f*p-f*y;for(let R=0;R!==a;++R)r[R]=m*o[u+R]+v*o[c+R]+E*o[l+R]+S*o[h+R];return r}},Ru=class extends vr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Pu=class extends vr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Iu=class extends vr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(i-t)/(s-t),y=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let y=o[c+g],p=o[l+g],m=f*d+g*2,v=h[m],E=h[m+1],S=e*d+g*2,R=u[S],C=u[S+1],x=jM(i,t,v,R,s);r[g]=cv(x,y,E,C,p)}return r}};function cv(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function QM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function jM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=cv(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=QM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Li=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Wo(t,this.TimeBufferType),this.values=Wo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Wo(e.times,Array),values:Wo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),nu(e.settings)&&(i.settings={inTangents:Wo(e.settings.inTangents,Array),outTangents:Wo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Pu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Ru(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Cu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Iu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ga:t=this.InterpolantFactoryMethodDiscrete;break;case _u:t=this.InterpolantFactoryMethodLinear;break;case ru:t=this.InterpolantFactoryMethodSmooth;break;case Lf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ga;case this.InterpolantFactoryMethodLinear:return _u;case this.InterpolantFactoryMethodSmooth:return ru;case this.InterpolantFactoryMethodBezier:return Lf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;nu(this.settings)&&(m_(this.settings.inTangents,e),m_(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;nu(this.settings)&&(g_(this.settings.inTangents,e),g_(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&AM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===ru,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let g=0;g!==i;++g){let y=t[h+g];if(y!==t[d+g]||y!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,nu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function m_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function g_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Li.prototype.ValueTypeName="";Li.prototype.TimeBufferType=Float32Array;Li.prototype.ValueBufferType=Float32Array;Li.prototype.DefaultInterpolation=_u;var xr=class extends Li{constructor(e,t,i){super(e,t,i)}};xr.prototype.ValueTypeName="bool";xr.prototype.ValueBufferType=Array;xr.prototype.DefaultInterpolation=Ga;xr.prototype.InterpolantFactoryMethodLinear=void 0;xr.prototype.InterpolantFactoryMethodSmooth=void 0;var Lu=class extends Li{constructor(e,t,i,s){super(e,t,i,s)}};Lu.prototype.ValueTypeName="color";var Du=class extends Li{constructor(e,t,i,s){super(e,t,i,s)}};Du.prototype.ValueTypeName="number";var Nu=class extends vr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)$t.slerpFlat(r,0,o,c-a,o,c,l);return r}},tl=class extends Li{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Nu(this.times,this.values,this.getValueSize(),e)}};tl.prototype.ValueTypeName="quaternion";tl.prototype.InterpolantFactoryMethodSmooth=void 0;var yr=class extends Li{constructor(e,t,i){super(e,t,i)}};yr.prototype.ValueTypeName="string";yr.prototype.ValueBufferType=Array;yr.prototype.DefaultInterpolation=Ga;yr.prototype.InterpolantFactoryMethodLinear=void 0;yr.prototype.InterpolantFactoryMethodSmooth=void 0;var Fu=class extends Li{constructor(e,t,i,s){super(e,t,i,s)}};Fu.prototype.ValueTypeName="vector";var Uu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],g=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},uv=new Uu,Ou=class{constructor(e){this.manager=e!==void 0?e:uv,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Ou.DEFAULT_MATERIAL_NAME="__DEFAULT";var nl=class extends ln{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new st(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},il=class extends nl{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new st(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},If=new Mt,__=new U,v_=new U,ku=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ct(512,512),this.mapType=Kn,this.map=null,this.mapPass=null,this.matrix=new Mt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new mr,this._frameExtents=new ct(1,1),this._viewportCount=1,this._viewports=[new an(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;__.setFromMatrixPosition(e.matrixWorld),t.position.copy(__),v_.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(v_),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){If.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(If,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Zo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(If)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},iu=new U,su=new $t,ps=new U,sl=class extends ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Mt,this.projectionMatrix=new Mt,this.projectionMatrixInverse=new Mt,this.coordinateSystem=Vi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(iu,su,ps),ps.x===1&&ps.y===1&&ps.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(iu,su,ps.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(iu,su,ps),ps.x===1&&ps.y===1&&ps.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(iu,su,ps.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},fr=new U,x_=new ct,y_=new ct,pi=class extends sl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=vu*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(au*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return vu*2*Math.atan(Math.tan(au*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){fr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(fr.x,fr.y).multiplyScalar(-e/fr.z),fr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(fr.x,fr.y).multiplyScalar(-e/fr.z)}getViewSize(e,t){return this.getViewBounds(e,x_,y_),t.subVectors(y_,x_)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(au*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var rl=class extends sl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Of=class extends ku{constructor(){super(new rl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ol=class extends nl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(ln.DEFAULT_UP),this.updateMatrix(),this.target=new ln,this.shadow=new Of}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Xo=-90,qo=1,na=class extends ln{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new pi(Xo,qo,e,t);s.layers=this.layers,this.add(s);let r=new pi(Xo,qo,e,t);r.layers=this.layers,this.add(r);let o=new pi(Xo,qo,e,t);o.layers=this.layers,this.add(o);let a=new pi(Xo,qo,e,t);a.layers=this.layers,this.add(a);let l=new pi(Xo,qo,e,t);l.layers=this.layers,this.add(l);let c=new pi(Xo,qo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Vi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Zo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Bu=class extends pi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var pp="\\[\\]\\.:\\/",ew=new RegExp("["+pp+"]","g"),mp="[^"+pp+"]",tw="[^"+pp.replace("\\.","")+"]",nw=/((?:WC+[\/:])*)/.source.replace("WC",mp),iw=/(WCOD+)?/.source.replace("WCOD",tw),sw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",mp),rw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",mp),ow=new RegExp("^"+nw+iw+sw+rw+"$"),aw=["material","materials","bones","map"],kf=class{constructor(e,t,i){let s=i||nn.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},nn=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(ew,"")}static parseTrackName(e){let t=ow.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);aw.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};nn.Composite=kf;nn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};nn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};nn.prototype.GetterByBindingType=[nn.prototype._getValue_direct,nn.prototype._getValue_array,nn.prototype._getValue_arrayElement,nn.prototype._getValue_toArray];nn.prototype.SetterByBindingTypeAndVersioning=[[nn.prototype._setValue_direct,nn.prototype._setValue_direct_setNeedsUpdate,nn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_array,nn.prototype._setValue_array_setNeedsUpdate,nn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_arrayElement,nn.prototype._setValue_arrayElement_setNeedsUpdate,nn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_fromArray,nn.prototype._setValue_fromArray_setNeedsUpdate,nn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var p2=new Float32Array(1);var b_=new Mt,br=class{constructor(e,t,i=0,s=1/0){this.ray=new Hr(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new Qo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):tt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return b_.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(b_),this}intersectObject(e,t=!0,i=[]){return Bf(e,this,i,t),i.sort(S_),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Bf(e[s],this,i,t);return i.sort(S_),i}};function S_(n,e){return n.distance-e.distance}function Bf(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Bf(r[o],e,t,!0)}}var zf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var al=class extends gr{constructor(e=10,t=10,i=4473924,s=8947848){i=new st(i),s=new st(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,g=-a;d<=t;d++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let y=d===r?i:s;y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3}let u=new Nt;u.setAttribute("position",new mt(l,3)),u.setAttribute("color",new mt(c,3));let h=new xi({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ll=class extends gr{constructor(e,t=16776960){let i=new Uint16Array([0,1,1,2,2,3,3,0,4,5,5,6,6,7,7,4,0,4,1,5,2,6,3,7]),s=[1,1,1,-1,1,1,-1,-1,1,1,-1,1,1,1,-1,-1,1,-1,-1,-1,-1,1,-1,-1],r=new Nt;r.setIndex(new Zn(i,1)),r.setAttribute("position",new mt(s,3)),super(r,new xi({color:t,toneMapped:!1})),this.box=e,this.type="Box3Helper",this.geometry.computeBoundingSphere()}updateMatrixWorld(e){let t=this.box;t.isEmpty()||(t.getCenter(this.position),t.getSize(this.scale),this.scale.multiplyScalar(.5),super.updateMatrixWorld(e))}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var cl=class extends Ji{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function gp(n,e,t,i){let s=lw(i);switch(t){case rp:return n*e;case ap:return n*e/s.components*s.byteLength;case oa:return n*e/s.components*s.byteLength;case Mr:return n*e*2/s.components*s.byteLength;case Yu:return n*e*2/s.components*s.byteLength;case op:return n*e*3/s.components*s.byteLength;case Di:return n*e*4/s.components*s.byteLength;case $u:return n*e*4/s.components*s.byteLength;case dl:case fl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case pl:case ml:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ku:case Qu:return Math.max(n,16)*Math.max(e,8)/4;case Zu:case Ju:return Math.max(n,8)*Math.max(e,8)/2;case ju:case eh:case nh:case ih:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case th:case gl:case sh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case rh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case oh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case ah:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case lh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case ch:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case uh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case hh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case dh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case fh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case ph:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case mh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case gh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case _h:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case vh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case xh:case yh:case bh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Sh:case Mh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case _l:case wh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function lw(n){switch(n){case Kn:case tp:return{byteLength:1,components:1};case Sr:case np:case ns:return{byteLength:2,components:1};case Xu:case qu:return{byteLength:2,components:4};case es:case Wu:case ts:return{byteLength:4,components:1};case ip:case sp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Lv(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function uw(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<h.length;f++){let g=h[d],y=h[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,h[d]=y)}h.length=d+1;for(let f=0,g=h.length;f<g;f++){let y=h[f];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var hw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,dw=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,fw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,pw=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,mw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,gw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,_w=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,vw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,xw=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,yw=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,bw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Sw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Mw=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,ww=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Ew=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Tw=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Aw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Cw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Rw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Pw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Iw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Lw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Dw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Nw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Fw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Uw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ow=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,kw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Bw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,zw="gl_FragColor = linearToOutputTexel( gl_FragColor );",Vw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Gw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Hw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Ww=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Xw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,qw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Yw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,$w=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Zw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Kw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Jw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Qw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,jw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,e1=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,t1=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,n1=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,i1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,s1=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,r1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,o1=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,a1=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,l1=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,c1=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,u1=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,h1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,d1=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,f1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,p1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,m1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,g1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,_1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,v1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,x1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,y1=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,b1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,S1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,M1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,w1=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,E1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,T1=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,A1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,C1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,R1=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,P1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,I1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,L1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,D1=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,N1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,F1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,U1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,O1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,k1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,B1=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,z1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,V1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,G1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,H1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,W1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,X1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,q1=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Y1=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,$1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Z1=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,K1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,J1=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Q1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,j1=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,eE=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,tE=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,nE=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,iE=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,sE=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,rE=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,oE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,aE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,lE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,cE=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,uE=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,hE=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,dE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fE=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mE=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gE=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,_E=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,vE=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,xE=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,yE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,bE=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,SE=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,ME=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,wE=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,EE=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,TE=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,AE=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,CE=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,RE=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,PE=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,IE=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,LE=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,DE=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,NE=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,FE=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,UE=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,OE=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kE=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,BE=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,zE=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,VE=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,GE=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,HE=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ft={alphahash_fragment:hw,alphahash_pars_fragment:dw,alphamap_fragment:fw,alphamap_pars_fragment:pw,alphatest_fragment:mw,alphatest_pars_fragment:gw,aomap_fragment:_w,aomap_pars_fragment:vw,batching_pars_vertex:xw,batching_vertex:yw,begin_vertex:bw,beginnormal_vertex:Sw,bsdfs:Mw,iridescence_fragment:ww,bumpmap_pars_fragment:Ew,clipping_planes_fragment:Tw,clipping_planes_pars_fragment:Aw,clipping_planes_pars_vertex:Cw,clipping_planes_vertex:Rw,color_fragment:Pw,color_pars_fragment:Iw,color_pars_vertex:Lw,color_vertex:Dw,common:Nw,defaultnormal_vertex:Fw,displacementmap_pars_vertex:Uw,displacementmap_vertex:Ow,emissivemap_fragment:kw,emissivemap_pars_fragment:Bw,colorspace_fragment:zw,colorspace_pars_fragment:Vw,envmap_fragment:Gw,envmap_common_pars_fragment:Hw,envmap_pars_fragment:Ww,envmap_pars_vertex:Xw,envmap_physical_pars_fragment:n1,envmap_vertex:qw,fog_vertex:Yw,fog_pars_vertex:$w,fog_fragment:Zw,fog_pars_fragment:Kw,gradientmap_pars_fragment:Jw,lightmap_pars_fragment:Qw,lights_lambert_fragment:jw,lights_lambert_pars_fragment:e1,lights_pars_begin:t1,lights_toon_fragment:i1,lights_toon_pars_fragment:s1,lights_phong_fragment:r1,lights_phong_pars_fragment:o1,lights_physical_fragment:a1,lights_physical_pars_fragment:l1,lights_fragment_begin:c1,lights_fragment_maps:u1,lights_fragment_end:h1,lightprobes_pars_fragment:d1,logdepthbuf_fragment:f1,logdepthbuf_pars_fragment:p1,logdepthbuf_pars_vertex:m1,logdepthbuf_vertex:g1,map_fragment:_1,map_pars_fragment:v1,map_particle_fragment:x1,map_particle_pars_fragment:y1,metalnessmap_fragment:b1,metalnessmap_pars_fragment:S1,morphinstance_vertex:M1,morphcolor_vertex:w1,morphnormal_vertex:E1,morphtarget_pars_vertex:T1,morphtarget_vertex:A1,normal_fragment_begin:C1,normal_fragment_maps:R1,normal_pars_fragment:P1,normal_pars_vertex:I1,normal_vertex:L1,normalmap_pars_fragment:D1,clearcoat_normal_fragment_begin:N1,clearcoat_normal_fragment_maps:F1,clearcoat_pars_fragment:U1,iridescence_pars_fragment:O1,opaque_fragment:k1,packing:B1,premultiplied_alpha_fragment:z1,project_vertex:V1,dithering_fragment:G1,dithering_pars_fragment:H1,roughnessmap_fragment:W1,roughnessmap_pars_fragment:X1,shadowmap_pars_fragment:q1,shadowmap_pars_vertex:Y1,shadowmap_vertex:$1,shadowmask_pars_fragment:Z1,skinbase_vertex:K1,skinning_pars_vertex:J1,skinning_vertex:Q1,skinnormal_vertex:j1,specularmap_fragment:eE,specularmap_pars_fragment:tE,tonemapping_fragment:nE,tonemapping_pars_fragment:iE,transmission_fragment:sE,transmission_pars_fragment:rE,uv_pars_fragment:oE,uv_pars_vertex:aE,uv_vertex:lE,worldpos_vertex:cE,background_vert:uE,background_frag:hE,backgroundCube_vert:dE,backgroundCube_frag:fE,cube_vert:pE,cube_frag:mE,depth_vert:gE,depth_frag:_E,distance_vert:vE,distance_frag:xE,equirect_vert:yE,equirect_frag:bE,linedashed_vert:SE,linedashed_frag:ME,meshbasic_vert:wE,meshbasic_frag:EE,meshlambert_vert:TE,meshlambert_frag:AE,meshmatcap_vert:CE,meshmatcap_frag:RE,meshnormal_vert:PE,meshnormal_frag:IE,meshphong_vert:LE,meshphong_frag:DE,meshphysical_vert:NE,meshphysical_frag:FE,meshtoon_vert:UE,meshtoon_frag:OE,points_vert:kE,points_frag:BE,shadow_vert:zE,shadow_frag:VE,sprite_vert:GE,sprite_frag:HE},Ne={common:{diffuse:{value:new st(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new ct(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new st(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new st(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new st(16777215)},opacity:{value:1},center:{value:new ct(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},Ss={basic:{uniforms:si([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:si([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new st(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:si([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new st(0)},specular:{value:new st(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:si([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new st(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:si([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new st(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:si([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:si([Ne.points,Ne.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:si([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:si([Ne.common,Ne.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:si([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:si([Ne.sprite,Ne.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:si([Ne.common,Ne.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:si([Ne.lights,Ne.fog,{color:{value:new st(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};Ss.physical={uniforms:si([Ss.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new ct(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new st(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new ct},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new st(0)},specularColor:{value:new st(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new ct},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Th={r:0,b:0,g:0},WE=new Mt,Dv=new it;Dv.set(-1,0,0,0,1,0,0,0,1);function XE(n,e,t,i,s,r){let o=new st(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(v){let E=v.isScene===!0?v.background:null;if(E&&E.isTexture){let S=v.backgroundBlurriness>0;E=e.get(E,S)}return E}function g(v){let E=!1,S=f(v);S===null?p(o,a):S&&S.isColor&&(p(S,1),E=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(v,E){let S=f(E);S&&S.isCubeTexture?(c===void 0&&(c=new Le(new Zt(1,1,1),new vs({name:"BackgroundCubeMaterial",uniforms:jr(Ss.backgroundCube.uniforms),vertexShader:Ss.backgroundCube.vertexShader,fragmentShader:Ss.backgroundCube.fragmentShader,side:gi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,C,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(WE.makeRotationFromEuler(E.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Dv),c.material.toneMapped=St.getTransfer(S.colorSpace)!==Dt,(u!==S||h!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Le(new qr(2,2),new vs({name:"BackgroundMaterial",uniforms:jr(Ss.background.uniforms),vertexShader:Ss.background.vertexShader,fragmentShader:Ss.background.fragmentShader,side:xs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=St.getTransfer(S.colorSpace)!==Dt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,E){v.getRGB(Th,fp(n)),t.buffers.color.setClear(Th.r,Th.g,Th.b,E,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,E=1){o.set(v),a=E,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:g,addToRenderList:y,dispose:m}}function qE(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(D,z,G,N,W){let $=!1,H=h(D,N,G,z);r!==H&&(r=H,c(r.object)),$=f(D,N,G,W),$&&g(D,N,G,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(D,z,G,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function h(D,z,G,N){let W=N.wireframe===!0,$=i[z.id];$===void 0&&($={},i[z.id]=$);let H=D.isInstancedMesh===!0?D.id:0,le=$[H];le===void 0&&(le={},$[H]=le);let Y=le[G.id];Y===void 0&&(Y={},le[G.id]=Y);let j=Y[W];return j===void 0&&(j=d(l()),Y[W]=j),j}function d(D){let z=[],G=[],N=[];for(let W=0;W<t;W++)z[W]=0,G[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:G,attributeDivisors:N,object:D,attributes:{},index:null}}function f(D,z,G,N){let W=r.attributes,$=z.attributes,H=0,le=G.getAttributes();for(let Y in le)if(le[Y].location>=0){let ie=W[Y],he=$[Y];if(he===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(he=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(he=D.instanceColor)),ie===void 0||ie.attribute!==he||he&&ie.data!==he.data)return!0;H++}return r.attributesNum!==H||r.index!==N}function g(D,z,G,N){let W={},$=z.attributes,H=0,le=G.getAttributes();for(let Y in le)if(le[Y].location>=0){let ie=$[Y];ie===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let he={};he.attribute=ie,ie&&ie.data&&(he.data=ie.data),W[Y]=he,H++}r.attributes=W,r.attributesNum=H,r.index=N}function y(){let D=r.newAttributes;for(let z=0,G=D.length;z<G;z++)D[z]=0}function p(D){m(D,0)}function m(D,z){let G=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;G[D]=1,N[D]===0&&(n.enableVertexAttribArray(D),N[D]=1),W[D]!==z&&(n.vertexAttribDivisor(D,z),W[D]=z)}function v(){let D=r.newAttributes,z=r.enabledAttributes;for(let G=0,N=z.length;G<N;G++)z[G]!==D[G]&&(n.disableVertexAttribArray(G),z[G]=0)}function E(D,z,G,N,W,$,H){H===!0?n.vertexAttribIPointer(D,z,G,W,$):n.vertexAttribPointer(D,z,G,N,W,$)}function S(D,z,G,N){y();let W=N.attributes,$=G.getAttributes(),H=z.defaultAttributeValues;for(let le in $){let Y=$[le];if(Y.location>=0){let j=W[le];if(j===void 0&&(le==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),le==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let ie=j.normalized,he=j.itemSize,de=e.get(j);if(de===void 0)continue;let ee=de.buffer,me=de.type,ve=de.bytesPerElement,Ce=me===n.INT||me===n.UNSIGNED_INT||j.gpuType===Wu;if(j.isInterleavedBufferAttribute){let Se=j.data,Ye=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,at=j.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let Xe=0;Xe<Y.locationSize;Xe++)m(Y.location+Xe,Se.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let Xe=0;Xe<Y.locationSize;Xe++)p(Y.location+Xe);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Xe=0;Xe<Y.locationSize;Xe++)E(Y.location+Xe,he/Y.locationSize,me,ie,Ye*ve,(at+he/Y.locationSize*Xe)*ve,Ce)}else{if(j.isInstancedBufferAttribute){for(let Se=0;Se<Y.locationSize;Se++)m(Y.location+Se,j.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let Se=0;Se<Y.locationSize;Se++)p(Y.location+Se);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Se=0;Se<Y.locationSize;Se++)E(Y.location+Se,he/Y.locationSize,me,ie,he*ve,he/Y.locationSize*Se*ve,Ce)}}else if(H!==void 0){let ie=H[le];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(Y.location,ie);break;case 3:n.vertexAttrib3fv(Y.location,ie);break;case 4:n.vertexAttrib4fv(Y.location,ie);break;default:n.vertexAttrib1fv(Y.location,ie)}}}}v()}function R(){O();for(let D in i){let z=i[D];for(let G in z){let N=z[G];for(let W in N){let $=N[W];for(let H in $)u($[H].object),delete $[H];delete N[W]}}delete i[D]}}function C(D){if(i[D.id]===void 0)return;let z=i[D.id];for(let G in z){let N=z[G];for(let W in N){let $=N[W];for(let H in $)u($[H].object),delete $[H];delete N[W]}}delete i[D.id]}function x(D){for(let z in i){let G=i[z];for(let N in G){let W=G[N];if(W[D.id]===void 0)continue;let $=W[D.id];for(let H in $)u($[H].object),delete $[H];delete W[D.id]}}}function w(D){for(let z in i){let G=i[z],N=D.isInstancedMesh===!0?D.id:0,W=G[N];if(W!==void 0){for(let $ in W){let H=W[$];for(let le in H)u(H[le].object),delete H[le];delete W[$]}delete G[N],Object.keys(G).length===0&&delete i[z]}}}function O(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:I,dispose:R,releaseStatesOfGeometry:C,releaseStatesOfObject:w,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:p,disableUnusedAttributes:v}}function YE(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function $E(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Di&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let w=x===ns&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==Kn&&x!==ts&&!w&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:v,maxVaryings:E,maxFragmentUniforms:S,maxSamples:R,samples:C}}function ZE(n){let e=this,t=null,i=0,s=!1,r=!1,o=new fi,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let g=h.clippingPlanes,y=h.clipIntersection,p=h.clipShadows,m=n.get(h);if(!s||g===null||g.length===0||r&&!p)r?u(null):c();else{let v=r?0:i,E=v*4,S=m.clippingState||null;l.value=S,S=u(g,d,E,f);for(let R=0;R!==E;++R)S[R]=t[R];m.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,g){let y=h!==null?h.length:0,p=null;if(y!==0){if(p=l.value,g!==!0||p===null){let m=f+y*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<m)&&(p=new Float32Array(m));for(let E=0,S=f;E!==y;++E,S+=4)o.copy(h[E]).applyMatrix4(v,a),o.normal.toArray(p,S),p[S+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var Sl=class extends Ii{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ja(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Zt(5,5,5),r=new vs({name:"CubemapFromEquirect",uniforms:jr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:gi,blending:Zr});r.uniforms.tEquirect.value=t;let o=new Le(s,r),a=t.minFilter;return t.minFilter===Hs&&(t.minFilter=mi),new na(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},hv=256,KE=3,JE=20,Nv=256,Fv=16,QE=3,jE=new U,eT=new st,Ch=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new na(1,10,null),this._boxMesh=new Le(new Zt(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=jE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(eT));let p=new na(i,s,u);return p.position.copy(a),p.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=pv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=fv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(hv,ov(e))}_fromTexture(e,t){e.mapping===Jr||e.mapping===ra?this._setSize(e.image.length===0?hv:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=dv(e,!1,!1),i=Math.log2(e)-KE;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=dv(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Jr||e.mapping===ra?(this._cubemapMaterial===null&&(this._cubemapMaterial=pv()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=fv()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=tT(),this._integrationMaterial=nT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Fv);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-QE)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Nv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=iT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function dv(n,e,t){return new Sl(n,{minFilter:Hs,generateMipmaps:e,type:ns,colorSpace:Ha,depthBuffer:t})}function Ml(n,e,t){return new vs({name:n,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:gi,blending:Zr,depthTest:!1,depthWrite:!1})}function tT(){return Ml("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Nv}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function nT(){return Ml("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Fv}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function iT(){return Ml("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${JE}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function fv(){return Ml("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function pv(){return Ml("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function sT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Vu||f===Gu)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new Sl(g.height);return y.fromEquirectangularTexture(n,d),e.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===Vu||f===Gu,y=f===Jr||f===ra;if(g||y){let p=t.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new Ch(n)),p=g?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let v=d.image;return g&&v&&v.height>0||y&&v&&l(v)?(i===null&&(i=new Ch(n)),p=g?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",u),p.texture):null}}}return d}function a(d,f){return f===Vu?d.mapping=Jr:f===Gu&&(d.mapping=ra),d}function l(d){let f=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function rT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Va("WebGLRenderer: "+i+" extension not supported."),s}}}function oT(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(g){let y=g.attributes;for(let p in y)e.update(y[p],n.ARRAY_BUFFER)}function h(g){let y=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let v=y!==null?y.array.length:p.array.length/3-1,E=p.count>=65535?Za:$a,S=new E(Math.ceil(v/3)*6,1),R=S.array;if(y!==null){let x=y.array;m=y.version;for(let w=0,O=0;w<v;w+=3){let I=x[w+0],D=x[w+1],z=x[w+2];R[O++]=I,R[O++]=D,R[O++]=D,R[O++]=z,R[O++]=z,R[O++]=I}}else{m=p.version;for(let x=0,w=0;x<v;x+=3){let O=x+0,I=x+1,D=x+2;R[w++]=O,R[w++]=I,R[w++]=I,R[w++]=D,R[w++]=D,R[w++]=O}}S.version=m;let C=r.get(g);C&&e.remove(C),r.set(g,S)}function d(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&h(g)}else h(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function aT(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let y=0;for(let p=0;p<f;p++)y+=d[p];t.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function lT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function cT(n,e,t){let i=new WeakMap,s=new an;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let O=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",O)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],E=0;f===!0&&(E=1),g===!0&&(E=2),y===!0&&(E=3);let S=a.attributes.position.count*E,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let C=new Float32Array(S*R*4*h),x=new qa(C,S,R,h);x.type=ts,x.needsUpdate=!0;let w=E*4;for(let I=0;I<h;I++){let D=p[I],z=m[I],G=v[I],N=S*R*4*I;for(let W=0;W<D.count;W++){let $=W*w;f===!0&&(s.fromBufferAttribute(D,W),C[N+$+0]=s.x,C[N+$+1]=s.y,C[N+$+2]=s.z,C[N+$+3]=0),g===!0&&(s.fromBufferAttribute(z,W),C[N+$+4]=s.x,C[N+$+5]=s.y,C[N+$+6]=s.z,C[N+$+7]=0),y===!0&&(s.fromBufferAttribute(G,W),C[N+$+8]=s.x,C[N+$+9]=s.y,C[N+$+10]=s.z,C[N+$+11]=G.itemSize===4?s.w:1)}}d={count:h,texture:x,size:new ct(S,R)},i.set(a,d),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function uT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var hT={[Yf]:"LINEAR_TONE_MAPPING",[$f]:"REINHARD_TONE_MAPPING",[Zf]:"CINEON_TONE_MAPPING",[Kf]:"ACES_FILMIC_TONE_MAPPING",[Qf]:"AGX_TONE_MAPPING",[jf]:"NEUTRAL_TONE_MAPPING",[Jf]:"CUSTOM_TONE_MAPPING"};function dT(n,e,t,i,s,r){let o=new Ii(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Nt;u.setAttribute("position",new mt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new mt([0,2,0,0,2,0],2));let h=new ta({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Le(u,h),f=new rl(-1,1,1,-1,0,1),g=null,y=null,p=!1,m,v=null,E=[],S=!1;this.setSize=function(R,C){o.setSize(R,C),a!==null&&a.setSize(R,C),l!==null&&l.setSize(R,C);for(let x=0;x<E.length;x++){let w=E[x];w.setSize&&w.setSize(R,C)}},this.setEffects=function(R){E=R,S=E.length>0&&E[0].isRenderPass===!0;let C=o.width,x=o.height;E.length>0&&a===null&&(a=new Ii(C,x,{type:ns,depthBuffer:!1,stencilBuffer:!1}),l=new Ii(C,x,{type:ns,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&E.some(O=>O.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Vs(C,x),r===!0&&(c.format=Ws,c.type=Qr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let O=0;O<E.length;O++){let I=E[O];I.setSize&&I.setSize(C,x),w&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(R,C){if(p||R.toneMapping===ys&&E.length===0)return!1;if(v=C,C!==null){let x=C.width,w=C.height;(o.width!==x||o.height!==w)&&this.setSize(x,w)}return S===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=ys,!0},this.hasRenderPass=function(){return S},this.end=function(R,C){R.toneMapping=m,p=!0;let x=o,w=a;for(let O=0;O<E.length;O++){let I=E[O];I.enabled!==!1&&(I.render(R,w,x,C),I.needsSwap!==!1&&(x=w,w=w===a?l:a))}if(g!==R.outputColorSpace||y!==R.toneMapping){g=R.outputColorSpace,y=R.toneMapping,h.defines={},St.getTransfer(g)===Dt&&(h.defines.SRGB_TRANSFER="");let O=hT[y];O&&(h.defines[O]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,R.setRenderTarget(v),R.render(d,f),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Uv=new vi,Ov=new Vs(1,1),kv=new Qa(1),Bv=new qa,zv=new bu,Vv=new Ja,mv=[],gv=[],_v=new Float32Array(16),vv=new Float32Array(9),xv=new Float32Array(4);function la(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=mv[s];if(r===void 0&&(r=new Float32Array(s),mv[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function kn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Bn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Ph(n,e){let t=gv[e];t===void 0&&(t=new Int32Array(e),gv[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function fT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function pT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(kn(t,e))return;n.uniform2fv(this.addr,e),Bn(t,e)}}function mT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(kn(t,e))return;n.uniform3fv(this.addr,e),Bn(t,e)}}function gT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(kn(t,e))return;n.uniform4fv(this.addr,e),Bn(t,e)}}function _T(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(kn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Bn(t,e)}else{if(kn(t,i))return;xv.set(i),n.uniformMatrix2fv(this.addr,!1,xv),Bn(t,i)}}function vT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(kn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Bn(t,e)}else{if(kn(t,i))return;vv.set(i),n.uniformMatrix3fv(this.addr,!1,vv),Bn(t,i)}}function xT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(kn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Bn(t,e)}else{if(kn(t,i))return;_v.set(i),n.uniformMatrix4fv(this.addr,!1,_v),Bn(t,i)}}function yT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function bT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(kn(t,e))return;n.uniform2iv(this.addr,e),Bn(t,e)}}function ST(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(kn(t,e))return;n.uniform3iv(this.addr,e),Bn(t,e)}}function MT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(kn(t,e))return;n.uniform4iv(this.addr,e),Bn(t,e)}}function wT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function ET(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(kn(t,e))return;n.uniform2uiv(this.addr,e),Bn(t,e)}}function TT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(kn(t,e))return;n.uniform3uiv(this.addr,e),Bn(t,e)}}function AT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(kn(t,e))return;n.uniform4uiv(this.addr,e),Bn(t,e)}}function Ih(n){return n.version===0&&(n.compareFunction=up,n.needsUpdate=!0),n}function CT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Ih(Ov):r=Uv,t.setTexture2D(e||r,s)}function RT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||zv,s)}function PT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Ih(kv):r=Vv,t.setTextureCube(e||r,s)}function IT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Bv,s)}function LT(n){switch(n){case 5126:return fT;case 35664:return pT;case 35665:return mT;case 35666:return gT;case 35674:return _T;case 35675:return vT;case 35676:return xT;case 5124:case 35670:return yT;case 35667:case 35671:return bT;case 35668:case 35672:return ST;case 35669:case 35673:return MT;case 5125:return wT;case 36294:return ET;case 36295:return TT;case 36296:return AT;case 35678:case 36198:case 36298:case 36306:case 35682:return CT;case 35679:case 36299:case 36307:return RT;case 35680:case 36300:case 36308:case 36293:return PT;case 36289:case 36303:case 36311:case 36292:return IT}}function DT(n,e){n.uniform1fv(this.addr,e)}function NT(n,e){let t=la(e,this.size,2);n.uniform2fv(this.addr,t)}function FT(n,e){let t=la(e,this.size,3);n.uniform3fv(this.addr,t)}function UT(n,e){let t=la(e,this.size,4);n.uniform4fv(this.addr,t)}function OT(n,e){let t=la(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function kT(n,e){let t=la(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function BT(n,e){let t=la(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function zT(n,e){n.uniform1iv(this.addr,e)}function VT(n,e){n.uniform2iv(this.addr,e)}function GT(n,e){n.uniform3iv(this.addr,e)}function HT(n,e){n.uniform4iv(this.addr,e)}function WT(n,e){n.uniform1uiv(this.addr,e)}function XT(n,e){n.uniform2uiv(this.addr,e)}function qT(n,e){n.uniform3uiv(this.addr,e)}function YT(n,e){n.uniform4uiv(this.addr,e)}function $T(n,e,t){let i=this.cache,s=e.length,r=Ph(t,s);kn(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Ih(Ov):o=Uv;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function ZT(n,e,t){let i=this.cache,s=e.length,r=Ph(t,s);kn(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||zv,r[o])}function KT(n,e,t){let i=this.cache,s=e.length,r=Ph(t,s);kn(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Ih(kv):o=Vv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function JT(n,e,t){let i=this.cache,s=e.length,r=Ph(t,s);kn(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Bv,r[o])}function QT(n){switch(n){case 5126:return DT;case 35664:return NT;case 35665:return FT;case 35666:return UT;case 35674:return OT;case 35675:return kT;case 35676:return BT;case 5124:case 35670:return zT;case 35667:case 35671:return VT;case 35668:case 35672:return GT;case 35669:case 35673:return HT;case 5125:return WT;case 36294:return XT;case 36295:return qT;case 36296:return YT;case 35678:case 36198:case 36298:case 36306:case 35682:return $T;case 35679:case 36299:case 36307:return ZT;case 35680:case 36300:case 36308:case 36293:return KT;case 36289:case 36303:case 36311:case 36292:return JT}}var xp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=LT(t.type)}},yp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=QT(t.type)}},bp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},_p=/(\w+)(\])?(\[|\.)?/g;function yv(n,e){n.seq.push(e),n.map[e.id]=e}function jT(n,e,t){let i=n.name,s=i.length;for(_p.lastIndex=0;;){let r=_p.exec(i),o=_p.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){yv(t,c===void 0?new xp(a,n,e):new yp(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new bp(a),yv(t,h)),t=h}}}var aa=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);jT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function bv(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var eA=37297,tA=0;function nA(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Sv=new it;function iA(n){St._getMatrix(Sv,St.workingColorSpace,n);let e=`mat3( ${Sv.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(n)){case Wa:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Mv(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+nA(n.getShaderSource(e),a)}else return r}function sA(n,e){let t=iA(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rA={[Yf]:"Linear",[$f]:"Reinhard",[Zf]:"Cineon",[Kf]:"ACESFilmic",[Qf]:"AgX",[jf]:"Neutral",[Jf]:"Custom"};function oA(n,e){let t=rA[e];return t===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ah=new U;function aA(){St.getLuminanceCoefficients(Ah);let n=Ah.x.toFixed(4),e=Ah.y.toFixed(4),t=Ah.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(bl).join(`
`)}function cA(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function uA(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function bl(n){return n!==""}function wv(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Ev(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var hA=/^[ \t]*#include +<([\w\d./]+)>/gm;function Sp(n){return n.replace(hA,dA)}function dA(n,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Sp(t)}var fA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Tv(n){return n.replace(fA,pA)}function pA(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Av(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var mA={[ul]:"SHADOWMAP_TYPE_PCF",[ia]:"SHADOWMAP_TYPE_VSM"};function gA(n){return mA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var _A={[ra]:"ENVMAP_MODE_REFRACTION"};function vA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":_A[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var xA={[zu]:"ENVMAP_BLENDING_MULTIPLY",[W_]:"ENVMAP_BLENDING_MIX",[X_]:"ENVMAP_BLENDING_ADD"};function yA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":xA[n.combine]||"ENVMAP_BLENDING_NONE"}function bA(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=gA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=vA(t),h=yA(t),d=lA(t),f=cA(r),g=s.createProgram(),y,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(bl).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(bl).join(`
`),p.length>0&&(p+=`
`)):(y=[Av(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(bl).join(`
`),p=[Av(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ys?"#define TONE_MAPPING":"",t.toneMapping!==ys?ft.tonemapping_pars_fragment:"",t.toneMapping!==ys?oA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,sA("linearToOutputTexel",t.outputColorSpace),aA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(bl).join(`
`)),o=Sp(o),o=wv(o,t),o=Ev(o,t),a=Sp(a),a=wv(a,t),a=Ev(a,t),o=Tv(o),a=Tv(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",t.glslVersion===vl?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===vl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=m+y+o,E=m+p+a,S=bv(s,s.VERTEX_SHADER,v),R=bv(s,s.FRAGMENT_SHADER,E);s.attachShader(g,S),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function C(I){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",z=s.getShaderInfoLog(S)||"",G=s.getShaderInfoLog(R)||"",N=D.trim(),W=z.trim(),$=G.trim(),H=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,S,R);else{let Y=Mv(s,S,"vertex"),j=Mv(s,R,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+N+`
`+Y+`
`+j)}else N!==""?Je("WebGLProgram: Program Info Log:",N):(W===""||$==="")&&(le=!1);le&&(I.diagnostics={runnable:H,programLog:N,vertexShader:{log:W,prefix:y},fragmentShader:{log:$,prefix:p}})}s.deleteShader(S),s.deleteShader(R),x=new aa(s,g),w=uA(s,g)}let x;this.getUniforms=function(){return x===void 0&&C(this),x};let w;this.getAttributes=function(){return w===void 0&&C(this),w};let O=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(g,eA)),O},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=tA++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=R,this}var SA=0,Mp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new wp(e),t.set(e,i)),i}},wp=class{constructor(e){this.id=SA++,this.code=e,this.usedTimes=0}};function MA(n){return n===Mr||n===gl||n===_l}function wA(n,e,t,i,s,r){let o=new Qo,a=new Mp,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,w,O,I,D,z){let G=I.fog,N=D.geometry,W=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,$=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,H=e.get(x.envMap||W,$),le=d[x.type],Y=i.precision;x.precision!==null&&(Y=i.getMaxPrecision(x.precision),Y!==x.precision&&Je("WebGLProgram.getParameters:",x.precision,"not supported, using",Y,"instead."));let j=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=j!==void 0?j.length:0,he=0;N.morphAttributes.position!==void 0&&(he=1),N.morphAttributes.normal!==void 0&&(he=2),N.morphAttributes.color!==void 0&&(he=3);let de,ee,me,ve;if(le){let Re=Ss[le];de=Re.vertexShader,ee=Re.fragmentShader}else{de=x.vertexShader,ee=x.fragmentShader;let Re=a.getVertexShaderStage(x),ut=a.getFragmentShaderStage(x);a.update(x,Re,ut),me=Re.id,ve=ut.id}let Ce=n.getRenderTarget(),Se=n.state.buffers.depth.getReversed(),Ye=D.isInstancedMesh===!0,at=D.isBatchedMesh===!0,Xe=!!x.map,pt=!!x.matcap,ht=!!H,rt=ht&&H.isPMREMTexture===!0,sn=!!x.aoMap,Yt=!!x.lightMap,wn=!!x.bumpMap&&x.wireframe===!1,zt=!!x.normalMap,zn=!!x.displacementMap,Et=!!x.emissiveMap,Dn=!!x.metalnessMap,dn=!!x.roughnessMap,En=x.anisotropy>0,B=x.clearcoat>0,Pe=x.diffuseRoughness>0,Ke=x.dispersion>0,lt=x.retroreflectivity>0,Me=x.iridescence>0,Ht=x.sheen>0,We=x.transmission>0,Ze=En&&!!x.anisotropyMap,P=B&&!!x.clearcoatMap,M=B&&!!x.clearcoatNormalMap,q=B&&!!x.clearcoatRoughnessMap,ue=Pe&&!!x.diffuseRoughnessMap,oe=Me&&!!x.iridescenceMap,_e=Me&&!!x.iridescenceThicknessMap,xe=Ht&&!!x.sheenColorMap,te=Ht&&!!x.sheenRoughnessMap,se=!!x.specularMap,pe=!!x.specularColorMap,k=!!x.specularIntensityMap,re=We&&!!x.transmissionMap,ne=We&&!!x.thicknessMap,we=!!x.gradientMap,ge=!!x.alphaMap,be=x.alphaTest>0,qe=!!x.alphaHash,je=!!x.extensions,ce=ys;x.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Be=rt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,et={shaderID:le,shaderType:x.type,shaderName:x.name,vertexShader:de,fragmentShader:ee,defines:x.defines,customVertexShaderID:me,customFragmentShaderID:ve,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Y,batching:at,batchingColor:at&&D._colorsTexture!==null,instancing:Ye,instancingColor:Ye&&D.instanceColor!==null,instancingMorph:Ye&&D.morphTexture!==null,outputColorSpace:Ce===null?n.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Xe,matcap:pt,envMap:ht,envMapMode:ht&&H.mapping,envMapPMREM:rt,envMapMaxLod:rt?Be.length-1:null,envMapSize:rt?Be[0].width:null,aoMap:sn,lightMap:Yt,bumpMap:wn,normalMap:zt,displacementMap:zn,emissiveMap:Et,normalMapObjectSpace:zt&&x.normalMapType===$_,normalMapTangentSpace:zt&&x.normalMapType===Eh,packedNormalMap:zt&&x.normalMapType===Eh&&MA(x.normalMap.format),metalnessMap:Dn,roughnessMap:dn,anisotropy:En,anisotropyMap:Ze,clearcoat:B,clearcoatMap:P,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Pe,diffuseRoughnessMap:ue,dispersion:Ke,retroreflection:lt,iridescence:Me,iridescenceMap:oe,iridescenceThicknessMap:_e,sheen:Ht,sheenColorMap:xe,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:k,transmission:We,transmissionMap:re,thicknessMap:ne,gradientMap:we,opaque:x.transparent===!1&&x.blending===sa&&x.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:qe,combine:x.combine,mapUv:Xe&&f(x.map.channel),aoMapUv:sn&&f(x.aoMap.channel),lightMapUv:Yt&&f(x.lightMap.channel),bumpMapUv:wn&&f(x.bumpMap.channel),normalMapUv:zt&&f(x.normalMap.channel),displacementMapUv:zn&&f(x.displacementMap.channel),emissiveMapUv:Et&&f(x.emissiveMap.channel),metalnessMapUv:Dn&&f(x.metalnessMap.channel),roughnessMapUv:dn&&f(x.roughnessMap.channel),anisotropyMapUv:Ze&&f(x.anisotropyMap.channel),clearcoatMapUv:P&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(x.sheenRoughnessMap.channel),specularMapUv:se&&f(x.specularMap.channel),specularColorMapUv:pe&&f(x.specularColorMap.channel),specularIntensityMapUv:k&&f(x.specularIntensityMap.channel),transmissionMapUv:re&&f(x.transmissionMap.channel),thicknessMapUv:ne&&f(x.thicknessMap.channel),alphaMapUv:ge&&f(x.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(zt||En),vertexNormals:!!N.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(Xe||ge),fog:!!G,useFog:x.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||N.attributes.normal===void 0&&zt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Se,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:he,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:z.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&O.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Xe&&x.map.isVideoTexture===!0&&St.getTransfer(x.map.colorSpace)===Dt,decodeVideoTextureEmissive:Et&&x.emissiveMap.isVideoTexture===!0&&St.getTransfer(x.emissiveMap.colorSpace)===Dt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===ii,flipSided:x.side===gi,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:je&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&x.extensions.multiDraw===!0||at)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function y(x){let w=[];if(x.shaderID?w.push(x.shaderID):(w.push(x.customVertexShaderID),w.push(x.customFragmentShaderID)),x.defines!==void 0)for(let O in x.defines)w.push(O),w.push(x.defines[O]);return x.isRawShaderMaterial===!1&&(p(w,x),m(w,x),w.push(n.outputColorSpace)),w.push(x.customProgramCacheKey),w.join()}function p(x,w){x.push(w.precision),x.push(w.outputColorSpace),x.push(w.envMapMode),x.push(w.envMapPMREM),x.push(w.envMapMaxLod),x.push(w.envMapSize),x.push(w.mapUv),x.push(w.alphaMapUv),x.push(w.lightMapUv),x.push(w.aoMapUv),x.push(w.bumpMapUv),x.push(w.normalMapUv),x.push(w.displacementMapUv),x.push(w.emissiveMapUv),x.push(w.metalnessMapUv),x.push(w.roughnessMapUv),x.push(w.anisotropyMapUv),x.push(w.clearcoatMapUv),x.push(w.clearcoatNormalMapUv),x.push(w.clearcoatRoughnessMapUv),x.push(w.diffuseRoughnessMapUv),x.push(w.iridescenceMapUv),x.push(w.iridescenceThicknessMapUv),x.push(w.sheenColorMapUv),x.push(w.sheenRoughnessMapUv),x.push(w.specularMapUv),x.push(w.specularColorMapUv),x.push(w.specularIntensityMapUv),x.push(w.transmissionMapUv),x.push(w.thicknessMapUv),x.push(w.combine),x.push(w.fogExp2),x.push(w.sizeAttenuation),x.push(w.morphTargetsCount),x.push(w.numSunLights),x.push(w.numDirLights),x.push(w.numPointLights),x.push(w.numSpotLights),x.push(w.numSpotLightMaps),x.push(w.numHemiLights),x.push(w.numRectAreaLights),x.push(w.numSunLightShadows),x.push(w.numDirLightShadows),x.push(w.numPointLightShadows),x.push(w.numSpotLightShadows),x.push(w.numSpotLightShadowsWithMaps),x.push(w.numLightProbes),x.push(w.numLightProbeGrids),x.push(w.shadowMapType),x.push(w.toneMapping),x.push(w.numClippingPlanes),x.push(w.numClipIntersection),x.push(w.depthPacking)}function m(x,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let w=d[x.type],O;if(w){let I=Ss[w];O=lv.clone(I.uniforms)}else O=x.uniforms;return O}function E(x,w){let O=u.get(w);return O!==void 0?++O.usedTimes:(O=new bA(n,w,x,s),c.push(O),u.set(w,O)),O}function S(x){if(--x.usedTimes===0){let w=c.indexOf(x);c[w]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function R(x){a.remove(x)}function C(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:E,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:C}}function EA(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function TA(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Cv(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Rv(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,y,p,m){let v=n[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:m},n[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=g,v.materialVariant=o(d),v.groupOrder=y,v.renderOrder=d.renderOrder,v.z=p,v.group=m),e++,v}function l(d,f,g,y,p,m,v){v.reversedDepth===!0&&(p=-p);let E=a(d,f,g,y,p,m);g.transmission>0?i.push(E):g.transparent===!0?s.push(E):t.push(E)}function c(d,f,g,y,p,m){let v=a(d,f,g,y,p,m);g.transmission>0?i.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function u(d,f){t.length>1&&t.sort(d||TA),i.length>1&&i.sort(f||Cv),s.length>1&&s.sort(f||Cv)}function h(){for(let d=e,f=n.length;d<f;d++){let g=n[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function AA(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Rv,n.set(i,[o])):s>=r.length?(o=new Rv,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function CA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new U,color:new st};break;case"SpotLight":t={position:new U,direction:new U,color:new st,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new U,color:new st,distance:0,decay:0};break;case"HemisphereLight":t={direction:new U,skyColor:new st,groundColor:new st};break;case"RectAreaLight":t={color:new st,position:new U,halfWidth:new U,halfHeight:new U};break}return n[e.id]=t,t}}}function RA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var PA=0;function IA(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function LA(n){let e=new CA,t=RA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new U);let s=new U,r=new Mt,o=new Mt;function a(c){let u=0,h=0,d=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let f=0,g=0,y=0,p=0,m=0,v=0,E=0,S=0,R=0,C=0,x=0,w=0,O=0,I=0;c.sort(IA);for(let z=0,G=c.length;z<G;z++){let N=c[z],W=N.color,$=N.intensity,H=N.distance,le=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Mr?le=N.shadow.map.texture:le=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=W.r*$,h+=W.g*$,d+=W.b*$;else if(N.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(N.sh.coefficients[Y],$);I++}else if(N.isSunLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[g]=ie,i.sunShadowMap[g]=le;let he=j.getViewportCount();for(let de=0;de<he;de++)i.sunShadowMatrix[y+de]=j.getMatrix(de),i.sunShadowCascade[y+de]=j._cascadeData[de];y+=he,g++}i.sun[f]=Y,f++}else if(N.isDirectionalLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,i.directionalShadow[p]=ie,i.directionalShadowMap[p]=le,i.directionalShadowMatrix[p]=N.shadow.matrix,R++}i.directional[p]=Y,p++}else if(N.isSpotLight){let Y=e.get(N);Y.position.setFromMatrixPosition(N.matrixWorld),Y.color.copy(W).multiplyScalar($),Y.distance=H,Y.coneCos=Math.cos(N.angle),Y.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Y.decay=N.decay,i.spot[v]=Y;let j=N.shadow;if(N.map&&(i.spotLightMap[w]=N.map,w++,j.updateMatrices(N),N.castShadow&&O++),i.spotLightMatrix[v]=j.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,i.spotShadow[v]=ie,i.spotShadowMap[v]=le,x++}v++}else if(N.isRectAreaLight){let Y=e.get(N);Y.color.copy(W).multiplyScalar($),Y.halfWidth.set(N.width*.5,0,0),Y.halfHeight.set(0,N.height*.5,0),i.rectArea[E]=Y,E++}else if(N.isPointLight){let Y=e.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),Y.distance=N.distance,Y.decay=N.decay,N.castShadow){let j=N.shadow,ie=t.get(N);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,ie.shadowCameraNear=j.camera.near,ie.shadowCameraFar=j.camera.far,i.pointShadow[m]=ie,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=N.shadow.matrix,C++}i.point[m]=Y,m++}else if(N.isHemisphereLight){let Y=e.get(N);Y.skyColor.copy(N.color).multiplyScalar($),Y.groundColor.copy(N.groundColor).multiplyScalar($),i.hemi[S]=Y,S++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let D=i.hash;(D.sunLength!==f||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==v||D.rectAreaLength!==E||D.hemiLength!==S||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==C||D.numSpotShadows!==x||D.numSpotMaps!==w||D.numLightProbes!==I)&&(i.sun.length=f,i.directional.length=p,i.spot.length=v,i.rectArea.length=E,i.point.length=m,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+w-O,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=O,i.numLightProbes=I,D.sunLength=f,D.directionalLength=p,D.pointLength=m,D.spotLength=v,D.rectAreaLength=E,D.hemiLength=S,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=C,D.numSpotShadows=x,D.numSpotMaps=w,D.numLightProbes=I,i.version=PA++)}function l(c,u){let h=0,d=0,f=0,g=0,y=0,p=0,m=u.matrixWorldInverse;for(let v=0,E=c.length;v<E;v++){let S=c[v];if(S.isSunLight){let R=i.sun[h];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),h++}else if(S.isDirectionalLight){let R=i.directional[d];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),d++}else if(S.isSpotLight){let R=i.spot[g];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),g++}else if(S.isRectAreaLight){let R=i.rectArea[y];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let R=i.point[f];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),f++}else if(S.isHemisphereLight){let R=i.hemi[p];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:i}}function Pv(n){let e=new LA(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function DA(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Pv(n),e.set(s,[a])):r>=o.length?(a=new Pv(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var NA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,FA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,UA=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],OA=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],Iv=new Mt,yl=new U,vp=new U;function kA(n,e,t){let i=new mr,s=new ct,r=new ct,o=new an,a=new Tu,l=new Au,c={},u=t.maxTextureSize,h={[xs]:gi,[gi]:xs,[ii]:ii},d=new vs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ct},radius:{value:4}},vertexShader:NA,fragmentShader:FA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Nt;g.setAttribute("position",new Zn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Le(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ul;let m=this.type;this.render=function(C,x,w){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||C.length===0)return;this.type===E_&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ul);let O=n.getRenderTarget(),I=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),z=n.state;z.setBlending(Zr),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let G=m!==this.type;G&&x.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=C.length;N<W;N++){let $=C[N],H=$.shadow;if(H===void 0){Je("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let le=H.getFrameExtents();s.multiply(le),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,H.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Y,H.map===null||G===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===ia){if($.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Ii(s.x,s.y,{format:Mr,type:ns,minFilter:mi,magFilter:mi,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new Vs(s.x,s.y,ts),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=zs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Ln,H.map.depthTexture.magFilter=Ln}else $.isPointLight?(H.map=new Sl(s.x),H.map.depthTexture=new Qa(s.x,es)):(H.map=new Ii(s.x,s.y),H.map.depthTexture=new Vs(s.x,s.y,es)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=zs,this.type===ul?(H.map.depthTexture.compareFunction=Y?cp:lp,H.map.depthTexture.minFilter=mi,H.map.depthTexture.magFilter=mi):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Ln,H.map.depthTexture.magFilter=Ln);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let j=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();$.isPointLight!==!0&&H.updateMatrices($,w);let ie=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:w.layers;for(let he=0;he<j;he++){let de=H.getCamera(he);if($.isPointLight){let ee=H.camera,me=H.matrix,ve=$.distance||ee.far;ve!==ee.far&&(ee.far=ve,ee.updateProjectionMatrix()),yl.setFromMatrixPosition($.matrixWorld),ee.position.copy(yl),vp.copy(ee.position),vp.add(UA[he]),ee.up.copy(OA[he]),ee.lookAt(vp),ee.updateMatrixWorld(),me.makeTranslation(-yl.x,-yl.y,-yl.z),Iv.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Iv,ee.coordinateSystem,ee.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,he),n.clear();else{he===0&&(n.setRenderTarget(H.map),n.clear());let ee=H.getViewport(he);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),z.viewport(o)}i=H.getFrustum(he),S(x,w,de,$,ie,this.type)}H.isPointLightShadow!==!0&&this.type===ia&&v(H,w),H.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(O,I,D)};function v(C,x){let w=e.update(y);d.defines.VSM_SAMPLES!==C.blurSamples&&(d.defines.VSM_SAMPLES=C.blurSamples,f.defines.VSM_SAMPLES=C.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),C.mapPass===null?C.mapPass=new Ii(s.x,s.y,{format:Mr,type:ns}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),d.uniforms.shadow_pass.value=C.map.depthTexture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(x,null,w,d,y,null),f.uniforms.shadow_pass.value=C.mapPass.texture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(x,null,w,f,y,null)}function E(C,x,w,O){let I=null,D=w.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(D!==void 0)I=D;else if(I=w.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let z=I.uuid,G=x.uuid,N=c[z];N===void 0&&(N={},c[z]=N);let W=N[G];W===void 0&&(W=I.clone(),N[G]=W,x.addEventListener("dispose",R)),I=W}if(I.visible=x.visible,I.wireframe=x.wireframe,O===ia?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:h[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,w.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let z=n.properties.get(I);z.light=w}return I}function S(C,x,w,O,I,D){if(C.visible===!1)return;if(C.layers.test(I)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&D===ia)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,C.matrixWorld);let N=e.update(C),W=C.material;if(Array.isArray(W)){let $=N.groups;for(let H=0,le=$.length;H<le;H++){let Y=$[H],j=W[Y.materialIndex];if(j&&j.visible){let ie=E(C,j,O,D);C.onBeforeShadow(n,C,x,w,N,ie,Y),n.renderBufferDirect(w,null,N,ie,C,Y),C.onAfterShadow(n,C,x,w,N,ie,Y)}}}else if(W.visible){let $=E(C,W,O,D);C.onBeforeShadow(n,C,x,w,N,$,null),n.renderBufferDirect(w,null,N,$,C,null),C.onAfterShadow(n,C,x,w,N,$,null)}}let G=C.children;for(let N=0,W=G.length;N<W;N++)S(G[N],x,w,O,I,D)}function R(C){C.target.removeEventListener("dispose",R);for(let w in c){let O=c[w],I=C.target.uuid;I in O&&(O[I].dispose(),delete O[I])}}}function BA(n,e){function t(){let k=!1,re=new an,ne=null,we=new an(0,0,0,0);return{setMask:function(ge){ne!==ge&&!k&&(n.colorMask(ge,ge,ge,ge),ne=ge)},setLocked:function(ge){k=ge},setClear:function(ge,be,qe,je,ce){ce===!0&&(ge*=je,be*=je,qe*=je),re.set(ge,be,qe,je),we.equals(re)===!1&&(n.clearColor(ge,be,qe,je),we.copy(re))},reset:function(){k=!1,ne=null,we.set(-1,0,0,0)}}}function i(){let k=!1,re=!1,ne=null,we=null,ge=null;return{setReversed:function(be){if(re!==be){let qe=e.get("EXT_clip_control");be?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),re=be;let je=ge;ge=null,this.setClear(je)}},getReversed:function(){return re},setTest:function(be){be?Se(n.DEPTH_TEST):Ye(n.DEPTH_TEST)},setMask:function(be){ne!==be&&!k&&(n.depthMask(be),ne=be)},setFunc:function(be){if(re&&(be=rv[be]),we!==be){switch(be){case lu:n.depthFunc(n.NEVER);break;case cu:n.depthFunc(n.ALWAYS);break;case uu:n.depthFunc(n.LESS);break;case $o:n.depthFunc(n.LEQUAL);break;case hu:n.depthFunc(n.EQUAL);break;case du:n.depthFunc(n.GEQUAL);break;case fu:n.depthFunc(n.GREATER);break;case pu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=be}},setLocked:function(be){k=be},setClear:function(be){ge!==be&&(ge=be,re&&(be=1-be),n.clearDepth(be))},reset:function(){k=!1,ne=null,we=null,ge=null,re=!1}}}function s(){let k=!1,re=null,ne=null,we=null,ge=null,be=null,qe=null,je=null,ce=null;return{setTest:function(Be){k||(Be?Se(n.STENCIL_TEST):Ye(n.STENCIL_TEST))},setMask:function(Be){re!==Be&&!k&&(n.stencilMask(Be),re=Be)},setFunc:function(Be,et,Re){(ne!==Be||we!==et||ge!==Re)&&(n.stencilFunc(Be,et,Re),ne=Be,we=et,ge=Re)},setOp:function(Be,et,Re){(be!==Be||qe!==et||je!==Re)&&(n.stencilOp(Be,et,Re),be=Be,qe=et,je=Re)},setLocked:function(Be){k=Be},setClear:function(Be){ce!==Be&&(n.clearStencil(Be),ce=Be)},reset:function(){k=!1,re=null,ne=null,we=null,ge=null,be=null,qe=null,je=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,g=[],y=null,p=!1,m=null,v=null,E=null,S=null,R=null,C=null,x=null,w=new st(0,0,0),O=0,I=!1,D=null,z=null,G=null,N=null,W=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,le=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Y)[1]),H=le>=1):Y.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),H=le>=2);let j=null,ie={},he=n.getParameter(n.SCISSOR_BOX),de=n.getParameter(n.VIEWPORT),ee=new an().fromArray(he),me=new an().fromArray(de);function ve(k,re,ne,we){let ge=new Uint8Array(4),be=n.createTexture();n.bindTexture(k,be),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let qe=0;qe<ne;qe++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(re+qe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return be}let Ce={};Ce[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Ce[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ce[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(n.DEPTH_TEST),o.setFunc($o),wn(!1),zt(Vf),Se(n.CULL_FACE),sn(Zr);function Se(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Ye(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function at(k,re){return d[k]!==re?(n.bindFramebuffer(k,re),d[k]=re,k===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=re),k===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Xe(k,re){let ne=g,we=!1;if(k){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let ge=k.textures;if(ne.length!==ge.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let be=0,qe=ge.length;be<qe;be++)ne[be]=n.COLOR_ATTACHMENT0+be;ne.length=ge.length,we=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,we=!0);we&&n.drawBuffers(ne)}function pt(k){return y!==k?(n.useProgram(k),y=k,!0):!1}let ht={[Kr]:n.FUNC_ADD,[A_]:n.FUNC_SUBTRACT,[C_]:n.FUNC_REVERSE_SUBTRACT};ht[R_]=n.MIN,ht[P_]=n.MAX;let rt={[I_]:n.ZERO,[L_]:n.ONE,[D_]:n.SRC_COLOR,[Xf]:n.SRC_ALPHA,[B_]:n.SRC_ALPHA_SATURATE,[O_]:n.DST_COLOR,[F_]:n.DST_ALPHA,[N_]:n.ONE_MINUS_SRC_COLOR,[qf]:n.ONE_MINUS_SRC_ALPHA,[k_]:n.ONE_MINUS_DST_COLOR,[U_]:n.ONE_MINUS_DST_ALPHA,[z_]:n.CONSTANT_COLOR,[V_]:n.ONE_MINUS_CONSTANT_COLOR,[G_]:n.CONSTANT_ALPHA,[H_]:n.ONE_MINUS_CONSTANT_ALPHA};function sn(k,re,ne,we,ge,be,qe,je,ce,Be){if(k===Zr){p===!0&&(Ye(n.BLEND),p=!1);return}if(p===!1&&(Se(n.BLEND),p=!0),k!==T_){if(k!==m||Be!==I){if((v!==Kr||R!==Kr)&&(n.blendEquation(n.FUNC_ADD),v=Kr,R=Kr),Be)switch(k){case sa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gf:n.blendFunc(n.ONE,n.ONE);break;case Hf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Wf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:tt("WebGLState: Invalid blending: ",k);break}else switch(k){case sa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Hf:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Wf:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",k);break}E=null,S=null,C=null,x=null,w.set(0,0,0),O=0,m=k,I=Be}return}ge=ge||re,be=be||ne,qe=qe||we,(re!==v||ge!==R)&&(n.blendEquationSeparate(ht[re],ht[ge]),v=re,R=ge),(ne!==E||we!==S||be!==C||qe!==x)&&(n.blendFuncSeparate(rt[ne],rt[we],rt[be],rt[qe]),E=ne,S=we,C=be,x=qe),(je.equals(w)===!1||ce!==O)&&(n.blendColor(je.r,je.g,je.b,ce),w.copy(je),O=ce),m=k,I=!1}function Yt(k,re){k.side===ii?Ye(n.CULL_FACE):Se(n.CULL_FACE);let ne=k.side===gi;re&&(ne=!ne),wn(ne),k.blending===sa&&k.transparent===!1?sn(Zr):sn(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let we=k.stencilWrite;a.setTest(we),we&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),Et(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Se(n.SAMPLE_ALPHA_TO_COVERAGE):Ye(n.SAMPLE_ALPHA_TO_COVERAGE)}function wn(k){D!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),D=k)}function zt(k){k!==M_?(Se(n.CULL_FACE),k!==z&&(k===Vf?n.cullFace(n.BACK):k===w_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ye(n.CULL_FACE),z=k}function zn(k){k!==G&&(H&&n.lineWidth(k),G=k)}function Et(k,re,ne){k?(Se(n.POLYGON_OFFSET_FILL),(N!==re||W!==ne)&&(N=re,W=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):Ye(n.POLYGON_OFFSET_FILL)}function Dn(k){k?Se(n.SCISSOR_TEST):Ye(n.SCISSOR_TEST)}function dn(k){k===void 0&&(k=n.TEXTURE0+$-1),j!==k&&(n.activeTexture(k),j=k)}function En(k,re,ne){ne===void 0&&(j===null?ne=n.TEXTURE0+$-1:ne=j);let we=ie[ne];we===void 0&&(we={type:void 0,texture:void 0},ie[ne]=we),(we.type!==k||we.texture!==re)&&(j!==ne&&(n.activeTexture(ne),j=ne),n.bindTexture(k,re||Ce[k]),we.type=k,we.texture=re)}function B(){let k=ie[j];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ke(){try{n.compressedTexImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function lt(){try{n.texSubImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function Me(){try{n.texSubImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ht(){try{n.compressedTexSubImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ze(){try{n.texStorage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function P(){try{n.texStorage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function M(){try{n.texImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function q(){try{n.texImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function ue(k){return h[k]!==void 0?h[k]:n.getParameter(k)}function oe(k,re){h[k]!==re&&(n.pixelStorei(k,re),h[k]=re)}function _e(k){ee.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),ee.copy(k))}function xe(k){me.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),me.copy(k))}function te(k,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let we=ne.get(k);we===void 0&&(we=n.getUniformBlockIndex(re,k.name),n.uniformBlockBinding(re,we,we),ne.set(k,we))}function se(k,re,ne){let ge=c.get(re).get(k);l[ge]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,ne),l[ge]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,ie={},d={},l={},f=new WeakMap,g=[],y=null,p=!1,m=null,v=null,E=null,S=null,R=null,C=null,x=null,w=new st(0,0,0),O=0,I=!1,D=null,z=null,G=null,N=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:Ye,bindFramebuffer:at,drawBuffers:Xe,useProgram:pt,setBlending:sn,setMaterial:Yt,setFlipSided:wn,setCullFace:zt,setLineWidth:zn,setPolygonOffset:Et,setScissorTest:Dn,activeTexture:dn,bindTexture:En,unbindTexture:B,compressedTexImage2D:Pe,compressedTexImage3D:Ke,texImage2D:M,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:Ze,texStorage3D:P,texSubImage2D:lt,texSubImage3D:Me,compressedTexSubImage2D:Ht,compressedTexSubImage3D:We,scissor:_e,viewport:xe,reset:pe}}function zA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ct,u=new WeakMap,h=new Set,d,f=new WeakMap,g=new Set,y=new FinalizationRegistry(P=>g.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,M){return p?new OffscreenCanvas(P,M):Xa("canvas")}function v(P,M,q){let ue=1,oe=Ze(P);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let _e=Math.floor(ue*oe.width),xe=Math.floor(ue*oe.height);d===void 0&&(d=m(_e,xe));let te=M?m(_e,xe):d;return te.width=_e,te.height=xe,te.getContext("2d").drawImage(P,0,0,_e,xe),Je("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+_e+"x"+xe+")."),te}else return"data"in P&&Je("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function E(P){return P.generateMipmaps}function S(P){n.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(P,M,q,ue,oe,_e=!1){if(P!==null){if(n[P]!==void 0)return n[P];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let xe;ue&&(xe=e.get("EXT_texture_norm16"),xe||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.R16_EXT),q===n.SHORT&&xe&&(te=xe.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),M===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.RG16_EXT),q===n.SHORT&&xe&&(te=xe.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&xe&&(te=xe.RGB16_EXT),q===n.SHORT&&xe&&(te=xe.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let se=_e?Wa:St.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=se===Dt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.RGBA16_EXT),q===n.SHORT&&xe&&(te=xe.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(P,M){let q;return P?M===null||M===es||M===Qr?q=n.DEPTH24_STENCIL8:M===ts?q=n.DEPTH32F_STENCIL8:M===Sr&&(q=n.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===es||M===Qr?q=n.DEPTH_COMPONENT24:M===ts?q=n.DEPTH_COMPONENT32F:M===Sr&&(q=n.DEPTH_COMPONENT16),q}function w(P,M){return E(P)===!0||P.isFramebufferTexture&&P.minFilter!==Ln&&P.minFilter!==mi?Math.log2(Math.max(M.width,M.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?M.mipmaps.length:1}function O(P){let M=new WeakRef(P);i.get(P).__ref=M,g.add(M),y.register(P,M,M)}function I(P){let M=i.get(P).__ref;M!==void 0&&(g.delete(M),y.unregister(M))}function D(P){G(P.target)}function z(P){N(P.target)}function G(P){P.removeEventListener("dispose",D),I(P),$(P),P.isVideoTexture&&u.delete(P),P.isHTMLTexture&&h.delete(P)}function N(P){P.removeEventListener("dispose",z),I(P),le(P)}function W(){for(let P of g){let M=P.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):G(M))}g.clear(),h.clear()}function $(P){let M=i.get(P);if(M.__webglInit===void 0)return;let q=P.source,ue=f.get(q);if(ue){let oe=ue[M.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(P),Object.keys(ue).length===0&&f.delete(q)}i.remove(P)}function H(P){let M=i.get(P);n.deleteTexture(M.__webglTexture);let q=P.source,ue=f.get(q);delete ue[M.__cacheKey],o.memory.textures--}function le(P){let M=i.get(P);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=P.depthTexture;if(q&&q.renderTarget===P&&G(q),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(M.__webglFramebuffer[oe]))for(let _e=0;_e<M.__webglFramebuffer[oe].length;_e++)n.deleteFramebuffer(M.__webglFramebuffer[oe][_e]);else n.deleteFramebuffer(M.__webglFramebuffer[oe]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[oe])}else{if(Array.isArray(M.__webglFramebuffer))for(let oe=0;oe<M.__webglFramebuffer.length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[oe]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let oe=0;oe<M.__webglColorRenderbuffer.length;oe++)M.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[oe]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=P.textures;for(let oe=0,_e=ue.length;oe<_e;oe++){let xe=i.get(ue[oe]);xe.__webglTexture&&(n.deleteTexture(xe.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(P)}let Y=0;function j(){Y=0}function ie(){return Y}function he(P){Y=P}function de(){let P=Y;return P>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,P}function ee(P){let M=[];return M.push(P.wrapS),M.push(P.wrapT),M.push(P.wrapR||0),M.push(P.magFilter),M.push(P.minFilter),M.push(P.anisotropy),M.push(P.internalFormat),M.push(P.format),M.push(P.type),M.push(P.generateMipmaps),M.push(P.mipmapsAutoUpdate),M.push(P.premultiplyAlpha),M.push(P.flipY),M.push(P.unpackAlignment),M.push(P.colorSpace),M.join()}function me(P,M){let q=i.get(P);if(P.isVideoTexture&&Ht(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&q.__version!==P.version){let ue=P.image;if(ue===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{Yt(q,P,M);return}}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function ve(P,M){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){Yt(q,P,M);return}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Ce(P,M){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){Yt(q,P,M);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function Se(P,M){let q=i.get(P);if(P.version>0&&q.__version!==P.version){wn(q,P,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let Ye={[mu]:n.REPEAT,[ms]:n.CLAMP_TO_EDGE,[gu]:n.MIRRORED_REPEAT},at={[Ln]:n.NEAREST,[q_]:n.NEAREST_MIPMAP_NEAREST,[hl]:n.NEAREST_MIPMAP_LINEAR,[mi]:n.LINEAR,[Hu]:n.LINEAR_MIPMAP_NEAREST,[Hs]:n.LINEAR_MIPMAP_LINEAR},Xe={[K_]:n.NEVER,[up]:n.ALWAYS,[J_]:n.LESS,[lp]:n.LEQUAL,[Q_]:n.EQUAL,[cp]:n.GEQUAL,[j_]:n.GREATER,[ev]:n.NOTEQUAL};function pt(P,M){if(M.type===ts&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===mi||M.magFilter===Hu||M.magFilter===hl||M.magFilter===Hs||M.minFilter===mi||M.minFilter===Hu||M.minFilter===hl||M.minFilter===Hs)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,Ye[M.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,Ye[M.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,Ye[M.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,at[M.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,at[M.minFilter]),M.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,Xe[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Ln||M.minFilter!==hl&&M.minFilter!==Hs||M.type===ts&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ht(P,M){let q=!1;P.__webglInit===void 0&&(P.__webglInit=!0,M.addEventListener("dispose",D),O(M));let ue=M.source,oe=f.get(ue);oe===void 0&&(oe={},f.set(ue,oe));let _e=ee(M);if(_e!==P.__cacheKey){oe[_e]===void 0&&(oe[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[_e].usedTimes++;let xe=oe[P.__cacheKey];xe!==void 0&&(oe[P.__cacheKey].usedTimes--,xe.usedTimes===0&&H(M)),P.__cacheKey=_e,P.__webglTexture=oe[_e].texture}return q}function rt(P,M,q){return Math.floor(Math.floor(P/q)/M)}function sn(P,M,q,ue){let _e=P.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ue,M.data);else{_e.sort((k,re)=>k.start-re.start);let xe=0;for(let k=1;k<_e.length;k++){let re=_e[xe],ne=_e[k],we=re.start+re.count,ge=rt(ne.start,M.width,4),be=rt(re.start,M.width,4);ne.start<=we+1&&ge===be&&rt(ne.start+ne.count-1,M.width,4)===ge?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++xe,_e[xe]=ne)}_e.length=xe+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let k=0,re=_e.length;k<re;k++){let ne=_e[k],we=Math.floor(ne.start/4),ge=Math.ceil(ne.count/4),be=we%M.width,qe=Math.floor(we/M.width),je=ge,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,be),t.pixelStorei(n.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(n.TEXTURE_2D,0,be,qe,je,ce,q,ue,M.data)}P.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Yt(P,M,q){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=ht(P,M),_e=M.source;t.bindTexture(ue,P.__webglTexture,n.TEXTURE0+q);let xe=i.get(_e);if(_e.version!==xe.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=St.getPrimaries(St.workingColorSpace),Be=M.colorSpace===Xs?null:St.getPrimaries(M.colorSpace),et=M.colorSpace===Xs||ce===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let se=v(M.image,!1,s.maxTextureSize);se=We(M,se);let pe=r.convert(M.format,M.colorSpace),k=r.convert(M.type),re=C(M.internalFormat,pe,k,M.normalized,M.colorSpace,M.isVideoTexture);pt(ue,M);let ne,we=M.mipmaps,ge=M.isVideoTexture!==!0,be=xe.__version===void 0||oe===!0,qe=_e.dataReady,je=w(M,se);if(M.isDepthTexture)re=x(M.format===Ws,M.type),be&&(ge?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,k,null));else if(M.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(n.TEXTURE_2D,je,re,we[0].width,we[0].height);for(let ce=0,Be=we.length;ce<Be;ce++)ne=we[ce],ge?qe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,k,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,k,ne.data);M.generateMipmaps=!1}else ge?(be&&t.texStorage2D(n.TEXTURE_2D,je,re,se.width,se.height),qe&&sn(M,se,pe,k)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,k,se.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ge&&be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,re,we[0].width,we[0].height,se.depth);for(let ce=0,Be=we.length;ce<Be;ce++)if(ne=we[ce],M.format!==Di)if(pe!==null)if(ge){if(qe)if(M.layerUpdates.size>0){let et=gp(ne.width,ne.height,M.format,M.type);for(let Re of M.layerUpdates){let ut=ne.data.subarray(Re*et/ne.data.BYTES_PER_ELEMENT,(Re+1)*et/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Re,ne.width,ne.height,1,pe,ut)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?qe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,k,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,k,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(n.TEXTURE_2D,je,re,we[0].width,we[0].height);for(let ce=0,Be=we.length;ce<Be;ce++)ne=we[ce],M.format!==Di?pe!==null?ge?qe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?qe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,k,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,k,ne.data)}else if(M.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,je,re,se.width,se.height,se.depth),qe)if(M.layerUpdates.size>0){let ce=gp(se.width,se.height,M.format,M.type);for(let Be of M.layerUpdates){let et=se.data.subarray(Be*ce/se.data.BYTES_PER_ELEMENT,(Be+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,pe,k,et)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,k,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,k,se.data);else if(M.isData3DTexture)ge?(be&&t.texStorage3D(n.TEXTURE_3D,je,re,se.width,se.height,se.depth),qe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,k,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,k,se.data);else if(M.isFramebufferTexture){if(be)if(ge)t.texStorage2D(n.TEXTURE_2D,je,re,se.width,se.height);else{let ce=se.width,Be=se.height;for(let et=0;et<je;et++)t.texImage2D(n.TEXTURE_2D,et,re,ce,Be,0,pe,k,null),ce>>=1,Be>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),h.add(M),ce.onpaint=Be=>{let et=Be.changedElements;for(let Re of h)et.includes(Re.image)&&(Re.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let et=n.RGBA,Re=n.RGBA,ut=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Re,ut,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let ce=Ze(we[0]);t.texStorage2D(n.TEXTURE_2D,je,re,ce.width,ce.height)}for(let ce=0,Be=we.length;ce<Be;ce++)ne=we[ce],ge?qe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,k,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,k,ne);M.generateMipmaps=!1}else if(ge){if(be){let ce=Ze(se);t.texStorage2D(n.TEXTURE_2D,je,re,ce.width,ce.height)}qe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,k,se)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,k,se);E(M)&&M.mipmapsAutoUpdate===!0&&S(ue),xe.__version=_e.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function wn(P,M,q){if(M.image.length!==6)return;let ue=ht(P,M),oe=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+q);let _e=i.get(oe);if(oe.version!==_e.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let xe=St.getPrimaries(St.workingColorSpace),te=M.colorSpace===Xs?null:St.getPrimaries(M.colorSpace),se=M.colorSpace===Xs||xe===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,k=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Re=0;Re<6;Re++)!pe&&!k?re[Re]=v(M.image[Re],!0,s.maxCubemapSize):re[Re]=k?M.image[Re].image:M.image[Re],re[Re]=We(M,re[Re]);let ne=re[0],we=r.convert(M.format,M.colorSpace),ge=r.convert(M.type),be=C(M.internalFormat,we,ge,M.normalized,M.colorSpace),qe=M.isVideoTexture!==!0,je=_e.__version===void 0||ue===!0,ce=oe.dataReady,Be=w(M,ne);pt(n.TEXTURE_CUBE_MAP,M);let et;if(M.isDepthTexture){if(be=x(M.format===Ws,M.type),je)if(qe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,be,ne.width,ne.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,ne.width,ne.height,0,we,ge,null)}else if(pe){qe&&je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,be,ne.width,ne.height);for(let Re=0;Re<6;Re++){et=re[Re].mipmaps;for(let ut=0;ut<et.length;ut++){let Kt=et[ut];M.format!==Di?we!==null?qe?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,0,0,Kt.width,Kt.height,we,Kt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,be,Kt.width,Kt.height,0,Kt.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,0,0,Kt.width,Kt.height,we,ge,Kt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,be,Kt.width,Kt.height,0,we,ge,Kt.data)}}}else{if(et=M.mipmaps,qe&&je){et.length>0&&Be++;let Re=Ze(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,be,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(k){qe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,re[Re].width,re[Re].height,we,ge,re[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,re[Re].width,re[Re].height,0,we,ge,re[Re].data);for(let ut=0;ut<et.length;ut++){let ri=et[ut].image[Re].image;qe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,0,0,ri.width,ri.height,we,ge,ri.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,be,ri.width,ri.height,0,we,ge,ri.data)}}else{qe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,we,ge,re[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,we,ge,re[Re]);for(let ut=0;ut<et.length;ut++){let Kt=et[ut];qe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,0,0,we,ge,Kt.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,be,we,ge,Kt.image[Re])}}}E(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),_e.__version=oe.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function zt(P,M,q,ue,oe,_e){let xe=r.convert(q.format,q.colorSpace),te=r.convert(q.type),se=C(q.internalFormat,xe,te,q.normalized,q.colorSpace),pe=i.get(M),k=i.get(q);if(k.__renderTarget=M,!pe.__hasExternalTextures){let re=Math.max(1,M.width>>_e),ne=Math.max(1,M.height>>_e);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,_e,se,re,ne,M.depth,0,xe,te,null):t.texImage2D(oe,_e,se,re,ne,0,xe,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,k.__webglTexture,0,lt(M)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,k.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function zn(P,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,P),M.depthBuffer){let ue=M.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,_e=x(M.stencilBuffer,oe),xe=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(M),_e,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(M),_e,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,_e,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,xe,n.RENDERBUFFER,P)}else{let ue=M.textures;for(let oe=0;oe<ue.length;oe++){let _e=ue[oe],xe=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),se=C(_e.internalFormat,xe,te,_e.normalized,_e.colorSpace);Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(M),se,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(M),se,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,se,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Et(P,M,q){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(M.depthTexture);oe.__renderTarget=M;let _e=ue?M.depthTexture.image[0]:M.depthTexture.image;(!oe.__webglTexture||_e.width!==M.width||_e.height!==M.height)&&(_e.width=M.width,_e.height=M.height,M.depthTexture.needsUpdate=!0),ue?Se(M.depthTexture,0):me(M.depthTexture,0);let xe=oe.__webglTexture,te=lt(M),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=M.depthTexture.format===Ws?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===zs)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,xe,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,xe,0);else if(M.depthTexture.format===Ws)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,xe,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,xe,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Dn(P){let M=i.get(P),q=P.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==P.depthTexture){let ue=P.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let oe=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),M.__depthDisposeCallback=oe}M.__boundDepthTexture=ue}if(P.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)Et(M.__webglFramebuffer[ue],P,ue);else P.texture.mipmaps.length>0?Et(M.__webglFramebuffer[0],P,0):Et(M.__webglFramebuffer,P,0);else if(q){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),zn(M.__webglDepthbuffer[ue],P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),zn(M.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function dn(P,M,q){let ue=i.get(P);M!==void 0&&zt(ue.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Dn(P)}function En(P){let M=P.texture,q=i.get(P),ue=i.get(M);P.addEventListener("dispose",z),O(P);let oe=P.textures,_e=P.isWebGLCubeRenderTarget===!0,xe=oe.length>1;if(xe||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let se=0;se<M.mipmaps.length;se++)q.__webglFramebuffer[te][se]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(xe)for(let te=0,se=oe.length;te<se;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&Me(P)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),k=r.convert(se.type),re=C(se.internalFormat,pe,k,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ne=lt(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),zn(q.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),pt(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)zt(q.__webglFramebuffer[te][se],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else zt(q.__webglFramebuffer[te],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);E(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(xe){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],k=i.get(pe),re=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,k.__webglTexture),pt(re,pe),zt(q.__webglFramebuffer,P,pe,n.COLOR_ATTACHMENT0+te,re,0),E(pe)&&S(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),pt(te,M),M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)zt(q.__webglFramebuffer[se],P,M,n.COLOR_ATTACHMENT0,te,se);else zt(q.__webglFramebuffer,P,M,n.COLOR_ATTACHMENT0,te,0);E(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&Dn(P)}function B(P){let M=P.textures;for(let q=0,ue=M.length;q<ue;q++){let oe=M[q];if(E(oe)&&oe.mipmapsAutoUpdate===!0){let _e=R(P),xe=i.get(oe).__webglTexture;t.bindTexture(_e,xe),S(_e),t.unbindTexture()}}}let Pe=[];function Ke(P){if(P.samples>0){if(Me(P)===!1){let M=P.textures,q=P.width,ue=P.height,oe=n.COLOR_BUFFER_BIT,_e=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=i.get(P),te=M.length>1;if(te)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,xe.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,xe.__webglColorRenderbuffer[pe]);let k=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+pe),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Pe.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,xe.__webglColorRenderbuffer[pe]);let k=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,k,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let M=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function lt(P){return Math.min(s.maxSamples,P.samples)}function Me(P){let M=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ht(P){let M=o.render.frame;u.get(P)!==M&&(u.set(P,M),P.update())}function We(P,M){let q=P.colorSpace,ue=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||q!==Ha&&q!==Xs&&(St.getTransfer(q)===Dt?(ue!==Di||oe!==Kn)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",q)),M}function Ze(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=j,this.getTextureUnits=ie,this.setTextureUnits=he,this.setTexture2D=me,this.setTexture2DArray=ve,this.setTexture3D=Ce,this.setTextureCube=Se,this.rebindTextures=dn,this.setupRenderTarget=En,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Ke,this.setupDepthRenderbuffer=Dn,this.setupFrameBufferTexture=zt,this.useMultisampledRTT=Me,this.dispose=W}function VA(n,e){function t(i,s=Xs){let r,o=St.getTransfer(s);if(i===Kn)return n.UNSIGNED_BYTE;if(i===Xu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===qu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===ip)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===sp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===tp)return n.BYTE;if(i===np)return n.SHORT;if(i===Sr)return n.UNSIGNED_SHORT;if(i===Wu)return n.INT;if(i===es)return n.UNSIGNED_INT;if(i===ts)return n.FLOAT;if(i===ns)return n.HALF_FLOAT;if(i===rp)return n.ALPHA;if(i===op)return n.RGB;if(i===Di)return n.RGBA;if(i===zs)return n.DEPTH_COMPONENT;if(i===Ws)return n.DEPTH_STENCIL;if(i===ap)return n.RED;if(i===oa)return n.RED_INTEGER;if(i===Mr)return n.RG;if(i===Yu)return n.RG_INTEGER;if(i===$u)return n.RGBA_INTEGER;if(i===dl||i===fl||i===pl||i===ml)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===dl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ml)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===dl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===pl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ml)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Zu||i===Ku||i===Ju||i===Qu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Zu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Ku)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ju)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Qu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===ju||i===eh||i===th||i===nh||i===ih||i===gl||i===sh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===ju||i===eh)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===th)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===nh)return r.COMPRESSED_R11_EAC;if(i===ih)return r.COMPRESSED_SIGNED_R11_EAC;if(i===gl)return r.COMPRESSED_RG11_EAC;if(i===sh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===rh||i===oh||i===ah||i===lh||i===ch||i===uh||i===hh||i===dh||i===fh||i===ph||i===mh||i===gh||i===_h||i===vh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===rh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===oh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ah)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===lh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ch)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===uh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===hh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===dh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===fh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ph)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===mh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===gh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===_h)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===vh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===xh||i===yh||i===bh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===xh)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===yh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===bh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Sh||i===Mh||i===_l||i===wh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Sh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Mh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===_l)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===wh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Qr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var GA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,HA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Ep=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ja(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new vs({vertexShader:GA,fragmentShader:HA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Le(new qr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Tp=class extends Ji{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",p=new Ep,m={},v=t.getContextAttributes(),E=null,S=null,R=[],C=[],x=new ct,w=null,O=null,I=new pi;I.viewport=new an;let D=new pi;D.viewport=new an;let z=[I,D],G=new Bu,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new jo,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new jo,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new jo,R[ee]=me),me.getHandSpace()};function $(ee){let me=C.indexOf(ee.inputSource);if(me===-1)return;let ve=R[me];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||o),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function H(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<R.length;ee++){let me=C[ee];me!==null&&(C[ee]=null,R[ee].disconnect(me))}N=null,W=null,p.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(E),f=null,d=null,h=null,s=null,S=null,de.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(x.width,x.height,!1),O!==null){let ee=O.camera;ee.fov=O.fov,ee.zoom=O.zoom,ee.updateProjectionMatrix(),O=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",H),s.addEventListener("inputsourceschange",le),v.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ce=null,Se=null;v.depth&&(Se=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=v.stencil?Ws:zs,Ce=v.stencil?Qr:es);let Ye={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Ye),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),S=new Ii(d.textureWidth,d.textureHeight,{format:Di,type:Kn,depthTexture:new Vs(d.textureWidth,d.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ve={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new Ii(f.framebufferWidth,f.framebufferHeight,{format:Di,type:Kn,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),de.setContext(s),de.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ve=ee.removed[me],Ce=C.indexOf(ve);Ce>=0&&(C[Ce]=null,R[Ce].disconnect(ve))}for(let me=0;me<ee.added.length;me++){let ve=ee.added[me],Ce=C.indexOf(ve);if(Ce===-1){for(let Ye=0;Ye<R.length;Ye++)if(Ye>=C.length){C.push(ve),Ce=Ye;break}else if(C[Ye]===null){C[Ye]=ve,Ce=Ye;break}if(Ce===-1)break}let Se=R[Ce];Se&&Se.connect(ve)}}function Y(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ve=ee.far;p.texture!==null&&(p.depthNear>0&&(me=p.depthNear),p.depthFar>0&&(ve=p.depthFar)),G.near=D.near=I.near=me,G.far=D.far=I.far=ve,(N!==G.near||W!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),N=G.near,W=G.far),G.layers.mask=ee.layers.mask|6,I.layers.mask=G.layers.mask&-5,D.layers.mask=G.layers.mask&-3;let Ce=ee.parent,Se=G.cameras;Y(G,Ce);for(let Ye=0;Ye<Se.length;Ye++)Y(Se[Ye],Ce);G.projectionMatrix.copy(I.projectionMatrix),G.projectionMatrixInverse.copy(I.projectionMatrixInverse),O===null&&ee.isPerspectiveCamera&&(O={camera:ee,fov:ee.fov,zoom:ee.zoom}),j(ee,G,Ce)};function j(ee,me,ve){ve===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=vu*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(G)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function he(ee,me){if(u=me.getViewerPose(c||o),g=me,u!==null){let ve=u.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let Ce=!1;ve.length!==G.cameras.length&&(G.cameras.length=0,Ce=!0);for(let Xe=0;Xe<ve.length;Xe++){let pt=ve[Xe],ht=null;if(f!==null)ht=f.getViewport(pt);else{let sn=h.getViewSubImage(d,pt);ht=sn.viewport,Xe===0&&(e.setRenderTargetTextures(S,sn.colorTexture,sn.depthStencilTexture),e.setRenderTarget(S))}let rt=z[Xe];rt===void 0&&(rt=new pi,rt.layers.enable(Xe),rt.viewport=new an,z[Xe]=rt),rt.matrix.fromArray(pt.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(pt.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ht.x,ht.y,ht.width,ht.height),Xe===0&&(G.matrix.copy(rt.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ce===!0&&G.cameras.push(rt)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let Xe=h.getDepthInformation(ve[0]);Xe&&Xe.isValid&&Xe.texture&&p.init(Xe,s.renderState)}if(Se&&Se.includes("camera-access")&&y){e.state.unbindTexture(),h=i.getBinding();for(let Xe=0;Xe<ve.length;Xe++){let pt=ve[Xe].camera;if(pt){let ht=m[pt];ht||(ht=new ja,m[pt]=ht);let rt=h.getCameraImage(pt);ht.sourceTexture=rt}}}}for(let ve=0;ve<R.length;ve++){let Ce=C[ve],Se=R[ve];Ce!==null&&Se!==void 0&&Se.update(Ce,me,c||o)}ie&&ie(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let de=new Lv;de.setAnimationLoop(he),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},WA=new Mt,Gv=new it;Gv.set(-1,0,0,0,1,0,0,0,1);function XA(n,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,fp(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,v,E,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),h(p,m)):m.isMeshPhongMaterial?(r(p,m),u(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,S)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,v,E):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===gi&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===gi&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let v=e.get(m),E=v.envMap,S=v.envMapRotation;E&&(p.envMap.value=E,p.envMapRotation.value.setFromMatrix4(WA.makeRotationFromEuler(S)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Gv),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,v,E){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*v,p.scale.value=E*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function u(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function h(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,v){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===gi&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let v=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function qA(n,e,t,i){let s={},r={};function o(v,E){let S=E.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,E){let S=s[v.id];S===void 0&&(g(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",p));let R=E.program;i.updateUBOMapping(v,R);let C=e.render.frame;r[v.id]!==C&&(c(v),r[v.id]=C)}function l(v){let E=n.createBuffer(),S=v.__size,R=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,S,R),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(v){let E=s[v.id],S=v.uniforms,R=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let C=0,x=S.length;C<x;C++){let w=S[C];if(Array.isArray(w))for(let O=0,I=w.length;O<I;O++)u(w[O],C,O,R);else u(w,C,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,E,S,R){if(d(v,E,S,R)===!0){let C=v.__offset,x=v.value;if(Array.isArray(x)){let w=0;for(let O=0;O<x.length;O++){let I=x[O],D=y(I,!0);h(I,v.__data,w),w+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,v.__data)}}function h(v,E,S){typeof v=="number"||typeof v=="boolean"?E[S]=v:v.isMatrix3?(E[S]=v.elements[0],E[S+1]=v.elements[1],E[S+2]=v.elements[2],E[S+3]=0,E[S+4]=v.elements[3],E[S+5]=v.elements[4],E[S+6]=v.elements[5],E[S+7]=0,E[S+8]=v.elements[6],E[S+9]=v.elements[7],E[S+10]=v.elements[8],E[S+11]=0):ArrayBuffer.isView(v)?E.set(v.subarray(0,E.length-S),S):v.toArray(E,S)}function d(v,E,S,R){let C=v.value,x=E+"_"+S;if(Array.isArray(C)){R[x]===void 0&&(R[x]=[]);let w=R[x],O=!1;for(let I=0;I<C.length;I++)f(C[I],w,I)===!0&&(O=!0);return O}return f(C,R,x)}function f(v,E,S){if(E[S]===void 0)return typeof v=="number"||typeof v=="boolean"?E[S]=v:ArrayBuffer.isView(v)?E[S]=v.slice():E[S]=v.clone(),!0;{let R=E[S];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return E[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function g(v){let E=v.uniforms,S=0,R=16;for(let x=0,w=E.length;x<w;x++){let O=Array.isArray(E[x])?E[x]:[E[x]];for(let I=0,D=O.length;I<D;I++){let z=O[I],G=Array.isArray(z.value)?z.value:[z.value],N=Array.isArray(E[x])||Array.isArray(z.value),W=S;for(let H=0,le=G.length;H<le;H++){let Y=G[H],j=y(Y,N),ie=S%R,he=ie%j.boundary,de=ie+he;S+=he,de!==0&&R-de<j.storage&&(S+=R-de),H===0&&(W=S),S+=j.storage}let $=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new $((S-W)/Float32Array.BYTES_PER_ELEMENT),z.__offset=W}}let C=S%R;return C>0&&(S+=R-C),v.__size=S,v.__cache={},this}function y(v,E){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",v),E===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function p(v){let E=v.target;E.removeEventListener("dispose",p),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function m(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var YA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),bs=null;function $A(){return bs===null&&(bs=new Wr(YA,16,16,Mr,ns),bs.name="DFG_LUT",bs.minFilter=mi,bs.magFilter=mi,bs.wrapS=ms,bs.wrapT=ms,bs.generateMipmaps=!1,bs.needsUpdate=!0),bs}var Rh=class{constructor(e={}){let{canvas:t=nv(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Kn}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let y=f,p=new Set([$u,Yu,oa]),m=new Set([Kn,es,Sr,Qr,Xu,qu]),v=new Uint32Array(4),E=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,C=null,x=[],w=[],O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ys,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,z=null,G=null,N=null,W=null;this._outputColorSpace=Pi;let $=0,H=0,le=null,Y=-1,j=null,ie=new an,he=new an,de=null,ee=new st(0),me=0,ve=t.width,Ce=t.height,Se=1,Ye=null,at=null,Xe=new an(0,0,ve,Ce),pt=new an(0,0,ve,Ce),ht=!1,rt=new mr,sn=new Su,Yt=!1,wn=!1,zt=new Mt,zn=new U,Et=new an,Dn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},dn=!1;function En(){return le===null?Se:1}let B=i;function Pe(A,V){return t.getContext(A,V)}let Ke,lt,Me,Ht,We,Ze,P,M,q,ue,oe,_e,xe,te,se,pe,k,re,ne,we,ge,be,qe;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Re,!1),B===null){let V="webgl2";if(B=Pe(V,A),B===null)throw Pe(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(A){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),tt("WebGLRenderer: "+A.message),A}function je(){Ke=new rT(B),Ke.init(),ge=new VA(B,Ke),lt=new $E(B,Ke,e,ge),Me=new BA(B,Ke),lt.reversedDepthBuffer&&d&&Me.buffers.depth.setReversed(!0),G=B.createFramebuffer(),N=B.createFramebuffer(),W=B.createFramebuffer(),Ht=new lT(B),We=new EA,Ze=new zA(B,Ke,Me,We,lt,ge,Ht),P=new sT(I),M=new uw(B),be=new qE(B,M),q=new oT(B,M,Ht,be),ue=new uT(B,q,M,be,Ht),re=new cT(B,lt,Ze),se=new ZE(We),oe=new wA(I,P,Ke,lt,be,se),_e=new XA(I,We),xe=new AA,te=new DA(Ke),k=new XE(I,P,Me,ue,g,l),pe=new kA(I,ue,lt),qe=new qA(B,Ht,lt,Me),ne=new YE(B,Ke,Ht),we=new aT(B,Ke,Ht),Ht.programs=oe.programs,I.capabilities=lt,I.extensions=Ke,I.properties=We,I.renderLists=xe,I.shadowMap=pe,I.state=Me,I.info=Ht}y!==Kn&&(O=new dT(y,t.width,t.height,a,s,r));let ce=new Tp(I,B);this.xr=ce,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let A=Ke.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Ke.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(A){A!==void 0&&(Se=A,this.setSize(ve,Ce,!1))},this.getSize=function(A){return A.set(ve,Ce)},this.setSize=function(A,V,Q=!0){if(ce.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=A,Ce=V,t.width=Math.floor(A*Se),t.height=Math.floor(V*Se),Q===!0&&(t.style.width=A+"px",t.style.height=V+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,A,V)},this.getDrawingBufferSize=function(A){return A.set(ve*Se,Ce*Se).floor()},this.setDrawingBufferSize=function(A,V,Q){ve=A,Ce=V,Se=Q,t.width=Math.floor(A*Q),t.height=Math.floor(V*Q),this.setViewport(0,0,A,V)},this.setEffects=function(A){if(y===Kn){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let V=0;V<A.length;V++)if(A[V].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(ie)},this.getViewport=function(A){return A.copy(Xe)},this.setViewport=function(A,V,Q,Z){A.isVector4?Xe.set(A.x,A.y,A.z,A.w):Xe.set(A,V,Q,Z),Me.viewport(ie.copy(Xe).multiplyScalar(En()).round())},this.getScissor=function(A){return A.copy(pt)},this.setScissor=function(A,V,Q,Z){A.isVector4?pt.set(A.x,A.y,A.z,A.w):pt.set(A,V,Q,Z),Me.scissor(he.copy(pt).multiplyScalar(En()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(A){Me.setScissorTest(ht=A)},this.setOpaqueSort=function(A){Ye=A},this.setTransparentSort=function(A){at=A},this.getClearColor=function(A){return A.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(A=!0,V=!0,Q=!0){let Z=0;if(A){let K=!1;if(le!==null){let Ee=le.texture.format;K=p.has(Ee)}if(K){let Ee=le.texture.type,Ie=m.has(Ee),Te=k.getClearColor(),De=k.getClearAlpha(),He=Te.r,nt=Te.g,gt=Te.b;Ie?(v[0]=He,v[1]=nt,v[2]=gt,v[3]=De,B.clearBufferuiv(B.COLOR,0,v)):(E[0]=He,E[1]=nt,E[2]=gt,E[3]=De,B.clearBufferiv(B.COLOR,0,E))}else Z|=B.COLOR_BUFFER_BIT}V&&(Z|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Z|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&B.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),z=A},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),k.dispose(),xe.dispose(),te.dispose(),Ze.dispose(),We.dispose(),P.dispose(),ue.dispose(),q.dispose(),be.dispose(),qe.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Rl),ce.removeEventListener("sessionend",is),ws.stop()};function Be(A){A.preventDefault(),hp("WebGLRenderer: Context Lost."),D=!0}function et(){hp("WebGLRenderer: Context Restored."),D=!1;let A=Ht.autoReset,V=pe.enabled,Q=pe.autoUpdate,Z=pe.needsUpdate,K=pe.type;je(),Ht.autoReset=A,pe.enabled=V,pe.autoUpdate=Q,pe.needsUpdate=Z,pe.type=K}function Re(A){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ut(A){let V=A.target;V.removeEventListener("dispose",ut),Kt(V)}function Kt(A){ri(A),We.remove(A)}function ri(A){let V=We.get(A).programs;V!==void 0&&(V.forEach(function(Q){oe.releaseProgram(Q)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,V,Q,Z,K,Ee){V===null&&(V=Dn);let Ie=K.isMesh&&K.matrixWorld.determinantAffine()<0,Te=pa(A,V,Q,Z,K);Me.setMaterial(Z,Ie);let De=Q.index,He=1;if(Z.wireframe===!0){if(De=q.getWireframeAttribute(Q),De===void 0)return;He=2}let nt=Q.drawRange,gt=Q.attributes.position,ze=nt.start*He,_t=(nt.start+nt.count)*He;Ee!==null&&(ze=Math.max(ze,Ee.start*He),_t=Math.min(_t,(Ee.start+Ee.count)*He)),De!==null?(ze=Math.max(ze,0),_t=Math.min(_t,De.count)):gt!=null&&(ze=Math.max(ze,0),_t=Math.min(_t,gt.count));let un=_t-ze;if(un<0||un===1/0)return;be.setup(K,Z,Te,Q,De);let Ft,Ut=ne;if(De!==null&&(Ft=M.get(De),Ut=we,Ut.setIndex(Ft)),K.isMesh)Z.wireframe===!0?(Me.setLineWidth(Z.wireframeLinewidth*En()),Ut.setMode(B.LINES)):Ut.setMode(B.TRIANGLES);else if(K.isLine){let Nn=Z.linewidth;Nn===void 0&&(Nn=1),Me.setLineWidth(Nn*En()),K.isLineSegments?Ut.setMode(B.LINES):K.isLineLoop?Ut.setMode(B.LINE_LOOP):Ut.setMode(B.LINE_STRIP)}else K.isPoints?Ut.setMode(B.POINTS):K.isSprite&&Ut.setMode(B.TRIANGLES);if(K.isBatchedMesh)if(Ke.get("WEBGL_multi_draw"))Ut.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let Nn=K._multiDrawStarts,Oe=K._multiDrawCounts,Tn=K._multiDrawCount,yt=De?M.get(De).bytesPerElement:1,Ts=We.get(Z).currentProgram.getUniforms();for(let An=0;An<Tn;An++)Ts.setValue(B,"_gl_DrawID",An),Ut.render(Nn[An]/yt,Oe[An])}else if(K.isInstancedMesh)Ut.renderInstances(ze,un,K.count);else if(Q.isInstancedBufferGeometry){let Nn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Oe=Math.min(Q.instanceCount,Nn);Ut.renderInstances(ze,un,Oe)}else Ut.render(ze,un)};function ha(A,V,Q,Z){z!==null&&A.isNodeMaterial&&z.setObject(Z,A),Yt===!0&&se.setState(A,Q,!1),A.transparent===!0&&A.side===ii&&A.forceSinglePass===!1?(A.side=gi,A.needsUpdate=!0,ss(A,V,Z),A.side=xs,A.needsUpdate=!0,ss(A,V,Z),A.side=ii):ss(A,V,Z)}this.compile=function(A,V,Q=null){Q===null&&(Q=A),z!==null&&z.renderStart(A,V,Q),C=te.get(Q),C.init(V),w.push(C),Q.traverseVisible(function(K){K.isLight&&K.layers.test(V.layers)&&(C.pushLight(K),K.castShadow&&C.pushShadow(K))}),A!==Q&&A.traverseVisible(function(K){K.isLight&&K.layers.test(V.layers)&&(C.pushLight(K),K.castShadow&&C.pushShadow(K))}),C.setupLights(),z!==null&&z.updateLights(C.state.lightsArray),wn=this.localClippingEnabled,Yt=se.init(this.clippingPlanes,wn),Yt===!0&&se.setGlobalState(this.clippingPlanes,V),z!==null&&pe.render(C.state.shadowsArray,Q,V);let Z=new Set;return A.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ee=K.material;if(Ee)if(Array.isArray(Ee))for(let Ie=0;Ie<Ee.length;Ie++){let Te=Ee[Ie];ha(Te,Q,V,K),Z.add(Te)}else ha(Ee,Q,V,K),Z.add(Ee)}),C=w.pop(),z!==null&&z.renderEnd(),Z},this.compileAsync=function(A,V,Q=null){let Z=this.compile(A,V,Q);return new Promise(K=>{function Ee(){if(Z.forEach(function(Ie){let De=We.get(Ie).currentProgram;(De===void 0||De.isReady())&&Z.delete(Ie)}),Z.size===0){K(A);return}setTimeout(Ee,10)}Ke.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let io=null;function Jh(A){io&&io(A)}function Rl(){ws.stop()}function is(){ws.start()}let ws=new Lv;ws.setAnimationLoop(Jh),typeof self<"u"&&ws.setContext(self),this.setAnimationLoop=function(A){io=A,ce.setAnimationLoop(A),A===null?ws.stop():ws.start()},ce.addEventListener("sessionstart",Rl),ce.addEventListener("sessionend",is),this.render=function(A,V){if(V!==void 0&&V.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;z!==null&&z.renderStart(A,V);let Q=ce.enabled===!0&&ce.isPresenting===!0,Z=O!==null&&(le===null||Q)&&O.begin(I,le);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(V),V=ce.getCamera()),A.isScene===!0&&A.onBeforeRender(I,A,V,le),C=te.get(A,w.length),C.init(V),C.state.textureUnits=Ze.getTextureUnits(),w.push(C),zt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?sn.setFromArrayCamera(V):rt.setFromProjectionMatrix(zt,Vi,V.reversedDepth),wn=this.localClippingEnabled,Yt=se.init(this.clippingPlanes,wn),R=xe.get(A,x.length),R.init(),x.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Ie=I.xr.getDepthSensingMesh();Ie!==null&&Es(Ie,V,-1/0,I.sortObjects)}Es(A,V,0,I.sortObjects),R.finish(),z!==null&&z.updateLights(C.state.lightsArray),I.sortObjects===!0&&R.sort(Ye,at),dn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,dn&&k.addToRenderList(R,A),this.info.autoReset===!0&&this.info.reset(),Yt===!0&&se.beginShadows();let K=C.state.shadowsArray;if(pe.render(K,A,V),Yt===!0&&se.endShadows(),(Z&&O.hasRenderPass())===!1){let Ie=R.opaque,Te=R.transmissive;if(C.setupLights(),V.isArrayCamera){let De=V.cameras;if(Te.length>0)for(let He=0,nt=De.length;He<nt;He++){let gt=De[He];Gi(Ie,Te,A,gt)}dn&&k.render(A);for(let He=0,nt=De.length;He<nt;He++){let gt=De[He];da(R,A,gt,gt.viewport)}}else Te.length>0&&Gi(Ie,Te,A,V),dn&&k.render(A),da(R,A,V)}le!==null&&H===0&&(Ze.updateMultisampleRenderTarget(le),Ze.updateRenderTargetMipmap(le)),Z&&O.end(I),A.isScene===!0&&A.onAfterRender(I,A,V),be.resetDefaultState(),Y=-1,j=null,w.pop(),w.length>0?(C=w[w.length-1],Ze.setTextureUnits(C.state.textureUnits),Yt===!0&&se.setGlobalState(I.clippingPlanes,C.state.camera)):C=null,x.pop(),x.length>0?R=x[x.length-1]:R=null,z!==null&&z.renderEnd()};function Es(A,V,Q,Z){if(A.visible===!1)return;if(A.layers.test(V.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(V);else if(A.isLight)C.pushLight(A),A.castShadow&&C.pushShadow(A);else if(A.isSprite){let Ie=V.isArrayCamera?sn:rt;if(!A.frustumCulled||A.intersectsFrustum(Ie)){Z&&Et.setFromMatrixPosition(A.matrixWorld).applyMatrix4(zt);let Te=ue.update(A),De=A.material;De.visible&&R.push(A,Te,De,Q,Et.z,null,V)}}else if(A.isMesh||A.isLine||A.isPoints){let Ie=V.isArrayCamera?sn:rt;if(!A.frustumCulled||A.intersectsFrustum(Ie)){let Te=ue.update(A),De=A.material;if(Z&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),Et.copy(A.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),Et.copy(Te.boundingSphere.center)),Et.applyMatrix4(A.matrixWorld).applyMatrix4(zt)),Array.isArray(De)){let He=Te.groups;for(let nt=0,gt=He.length;nt<gt;nt++){let ze=He[nt],_t=De[ze.materialIndex];_t&&_t.visible&&R.push(A,Te,_t,Q,Et.z,ze,V)}}else De.visible&&R.push(A,Te,De,Q,Et.z,null,V)}}}let Ee=A.children;for(let Ie=0,Te=Ee.length;Ie<Te;Ie++)Es(Ee[Ie],V,Q,Z)}function da(A,V,Q,Z){let{opaque:K,transmissive:Ee,transparent:Ie}=A;C.setupLightsView(Q),Yt===!0&&se.setGlobalState(I.clippingPlanes,Q),Z&&Me.viewport(ie.copy(Z)),K.length>0&&fn(K,V,Q),Ee.length>0&&fn(Ee,V,Q),Ie.length>0&&fn(Ie,V,Q),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Gi(A,V,Q,Z){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[Z.id]===void 0){let ze=Ke.has("EXT_color_buffer_half_float")||Ke.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[Z.id]=new Ii(1,1,{generateMipmaps:!0,type:ze?ns:Kn,minFilter:Hs,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ee=C.state.transmissionRenderTarget[Z.id],Ie=Z.viewport||ie;Ee.setSize(Ie.z*I.transmissionResolutionScale,Ie.w*I.transmissionResolutionScale);let Te=I.getRenderTarget(),De=I.getActiveCubeFace(),He=I.getActiveMipmapLevel();I.setRenderTarget(Ee),I.getClearColor(ee),me=I.getClearAlpha(),me<1&&I.setClearColor(16777215,.5),I.clear(),dn&&k.render(Q);let nt=I.toneMapping;I.toneMapping=ys;let gt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),C.setupLightsView(Z),Yt===!0&&se.setGlobalState(I.clippingPlanes,Z),fn(A,Q,Z),Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee),Ke.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let _t=0,un=V.length;_t<un;_t++){let Ft=V[_t],{object:Ut,geometry:Nn,material:Oe,group:Tn}=Ft;if(Oe.side===ii&&Ut.layers.test(Z.layers)){let yt=Oe.side;Oe.side=gi,Oe.needsUpdate=!0,yn(Ut,Q,Z,Nn,Oe,Tn),Oe.side=yt,Oe.needsUpdate=!0,ze=!0}}ze===!0&&(Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee))}I.setRenderTarget(Te,De,He),I.setClearColor(ee,me),gt!==void 0&&(Z.viewport=gt),I.toneMapping=nt}function fn(A,V,Q){let Z=V.isScene===!0?V.overrideMaterial:null;for(let K=0,Ee=A.length;K<Ee;K++){let Ie=A[K],{object:Te,geometry:De,group:He}=Ie,nt=Ie.material;nt.allowOverride===!0&&Z!==null&&(nt=Z),Te.layers.test(Q.layers)&&yn(Te,V,Q,De,nt,He)}}function yn(A,V,Q,Z,K,Ee){z!==null&&K.isNodeMaterial&&z.setObject(A,K),A.onBeforeRender(I,V,Q,Z,K,Ee),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),K.onBeforeRender(I,V,Q,Z,A,Ee),K.transparent===!0&&K.side===ii&&K.forceSinglePass===!1?(K.side=gi,K.needsUpdate=!0,I.renderBufferDirect(Q,V,Z,K,A,Ee),K.side=xs,K.needsUpdate=!0,I.renderBufferDirect(Q,V,Z,K,A,Ee),K.side=ii):I.renderBufferDirect(Q,V,Z,K,A,Ee),A.onAfterRender(I,V,Q,Z,K,Ee)}function bn(A){let V=0;for(let Q of A)Q.texture!==null&&V++;return V}function ss(A,V,Q){V.isScene!==!0&&(V=Dn);let Z=We.get(A),K=C.state.lights,Ee=C.state.shadowsArray,Ie=K.state.version,Te=oe.getParameters(A,K.state,Ee,V,Q,C.state.lightProbeGridArray),De=oe.getProgramCacheKey(Te),He=Z.programs;Z.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?V.environment:null,Z.fog=V.fog;let nt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Z.envMap=P.get(A.envMap||Z.environment,nt),Z.envMapRotation=Z.environment!==null&&A.envMap===null?V.environmentRotation:A.envMapRotation,He===void 0&&(A.addEventListener("dispose",ut),He=new Map,Z.programs=He,Z.programVariants=new Map);let gt=He.get(De);if(gt!==void 0){if(Z.currentProgram===gt&&Z.lightsStateVersion===Ie)return fa(A,Te),gt}else Te.uniforms=oe.getUniforms(A),z!==null&&A.isNodeMaterial&&z.build(A,Q,Te),A.onBeforeCompile(Te,I),gt=oe.acquireProgram(Te,De),He.set(De,gt),Z.uniforms=Te.uniforms;let ze=Z.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(ze.clippingPlanes=se.uniform),fa(A,Te),Z.needsLights=Ys(A),Z.lightsStateVersion=Ie,Z.needsLights&&(ze.ambientLightColor.value=K.state.ambient,ze.lightProbe.value=K.state.probe,ze.sunLights.value=K.state.sun,ze.sunLightShadows.value=K.state.sunShadow,ze.directionalLights.value=K.state.directional,ze.directionalLightShadows.value=K.state.directionalShadow,ze.spotLights.value=K.state.spot,ze.spotLightShadows.value=K.state.spotShadow,ze.rectAreaLights.value=K.state.rectArea,ze.ltc_1.value=K.state.rectAreaLTC1,ze.ltc_2.value=K.state.rectAreaLTC2,ze.pointLights.value=K.state.point,ze.pointLightShadows.value=K.state.pointShadow,ze.hemisphereLights.value=K.state.hemi,ze.sunShadowMatrix.value=K.state.sunShadowMatrix,ze.sunShadowCascade.value=K.state.sunShadowCascade,ze.directionalShadowMatrix.value=K.state.directionalShadowMatrix,ze.spotLightMatrix.value=K.state.spotLightMatrix,ze.spotLightMap.value=K.state.spotLightMap,ze.pointShadowMatrix.value=K.state.pointShadowMatrix),Z.numLightProbeGrids=bn(C.state.lightProbeGridArray),Z.currentProgram=gt,Z.uniformsList=null,gt}function yi(A,V,Q,Z,K){let Ee=We.get(A),Ie=Ee.currentProgram.id+","+Z+","+K,Te=Ee.programVariants.get(Ie);return Te===void 0?(Te=ss(A,V,Q),Ee.programVariants.set(Ie,Te)):(Ee.currentProgram=Te,Ee.uniformsList=null,Ee.outputColorSpace=Z,Ee.toneMapping=K),Te}function qs(A){if(A.uniformsList===null){let V=A.currentProgram.getUniforms();A.uniformsList=aa.seqWithValue(V.seq,A.uniforms)}return A.uniformsList}function fa(A,V){let Q=We.get(A);Q.outputColorSpace=V.outputColorSpace,Q.batching=V.batching,Q.batchingColor=V.batchingColor,Q.instancing=V.instancing,Q.instancingColor=V.instancingColor,Q.instancingMorph=V.instancingMorph,Q.skinning=V.skinning,Q.morphTargets=V.morphTargets,Q.morphNormals=V.morphNormals,Q.morphColors=V.morphColors,Q.morphTargetsCount=V.morphTargetsCount,Q.numClippingPlanes=V.numClippingPlanes,Q.numIntersection=V.numClipIntersection,Q.vertexAlphas=V.vertexAlphas,Q.vertexTangents=V.vertexTangents,Q.toneMapping=V.toneMapping}function pa(A,V,Q,Z,K){V.isScene!==!0&&(V=Dn),Ze.resetTextureUnits();let Ee=V.fog,Ie=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?V.environment:null,Te=le===null?I.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:St.workingColorSpace,De=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,He=P.get(Z.envMap||Ie,De),nt=Z.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,gt=!!Q.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),ze=!!Q.morphAttributes.position,_t=!!Q.morphAttributes.normal,un=!!Q.morphAttributes.color,Ft=ys;Z.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Ft=I.toneMapping);let Ut=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,Nn=Ut!==void 0?Ut.length:0,Oe=We.get(Z),Tn=C.state.lights;if(Yt===!0&&(wn===!0||A!==j)){let Ot=A===j&&Z.id===Y;se.setState(Z,A,Ot)}let yt=!1,Ts=!1;Z.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==Tn.state.version||K.isBatchedMesh&&Oe.batching===!1||!K.isBatchedMesh&&Oe.batching===!0||K.isBatchedMesh&&Oe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Oe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Oe.instancing===!1||!K.isInstancedMesh&&Oe.instancing===!0||K.isSkinnedMesh&&Oe.skinning===!1||!K.isSkinnedMesh&&Oe.skinning===!0||K.isInstancedMesh&&Oe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Oe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Oe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Oe.instancingMorph===!1&&K.morphTexture!==null||Oe.envMap!==He||Z.fog===!0&&Oe.fog!==Ee||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==se.numPlanes||Oe.numIntersection!==se.numIntersection)||Oe.vertexAlphas!==nt||Oe.vertexTangents!==gt||Oe.morphTargets!==ze||Oe.morphNormals!==_t||Oe.morphColors!==un||Oe.morphTargetsCount!==Nn||Oe.numLightProbeGrids!==bn(C.state.lightProbeGridArray)?yt=!0:(Oe.outputColorSpace!==Te||Oe.toneMapping!==Ft)&&(Ts=!0):(yt=!0,Oe.__version=Z.version);let An=Oe.currentProgram;(yt===!0||Ts===!0)&&(An=Ts===!0?yi(Z,V,K,Te,Ft):ss(Z,V,K),z&&Z.isNodeMaterial&&z.onUpdateProgram(Z,An,Oe));let oo=!1,rs=!1,As=!1,dt=An.getUniforms(),pn=Oe.uniforms;if(Me.useProgram(An.program)&&(oo=!0,rs=!0,As=!0),Z.id!==Y&&(Y=Z.id,rs=!0),oo||j!==A){Me.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),dt.setValue(B,"projectionMatrix",A.projectionMatrix),dt.setValue(B,"viewMatrix",A.matrixWorldInverse);let Cn=dt.map.cameraPosition;Cn!==void 0&&Cn.setValue(B,zn.setFromMatrixPosition(A.matrixWorld)),lt.logarithmicDepthBuffer&&dt.setValue(B,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&dt.setValue(B,"isOrthographic",A.isOrthographicCamera===!0),j!==A&&(j=A,rs=!0,As=!0)}if(Oe.needsLights&&(Tn.state.sunShadowMap.length>0&&dt.setValue(B,"sunShadowMap",Tn.state.sunShadowMap,Ze),Tn.state.directionalShadowMap.length>0&&dt.setValue(B,"directionalShadowMap",Tn.state.directionalShadowMap,Ze),Tn.state.spotShadowMap.length>0&&dt.setValue(B,"spotShadowMap",Tn.state.spotShadowMap,Ze),Tn.state.pointShadowMap.length>0&&dt.setValue(B,"pointShadowMap",Tn.state.pointShadowMap,Ze)),K.isSkinnedMesh){dt.setOptional(B,K,"bindMatrix"),dt.setOptional(B,K,"bindMatrixInverse");let Ot=K.skeleton;Ot&&(Ot.boneTexture===null&&Ot.computeBoneTexture(),dt.setValue(B,"boneTexture",Ot.boneTexture,Ze))}K.isBatchedMesh&&(dt.setOptional(B,K,"batchingTexture"),dt.setValue(B,"batchingTexture",K._matricesTexture,Ze),dt.setOptional(B,K,"batchingIdTexture"),dt.setValue(B,"batchingIdTexture",K._indirectTexture,Ze),dt.setOptional(B,K,"batchingColorTexture"),K._colorsTexture!==null&&dt.setValue(B,"batchingColorTexture",K._colorsTexture,Ze));let oi=Q.morphAttributes;if((oi.position!==void 0||oi.normal!==void 0||oi.color!==void 0)&&re.update(K,Q,An),(rs||Oe.receiveShadow!==K.receiveShadow)&&(Oe.receiveShadow=K.receiveShadow,dt.setValue(B,"receiveShadow",K.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&V.environment!==null&&(pn.envMapIntensity.value=V.environmentIntensity),pn.dfgLUT!==void 0&&(pn.dfgLUT.value=$A()),rs){if(dt.setValue(B,"toneMappingExposure",I.toneMappingExposure),Oe.needsLights&&so(pn,As),Ee&&Z.fog===!0&&_e.refreshFogUniforms(pn,Ee),_e.refreshMaterialUniforms(pn,Z,Se,Ce,C.state.transmissionRenderTarget[A.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Ot=S,Cn=0;for(let Jn of C.state.lightProbeGridArray)Jn.texture!==null&&(Ot.textures[Cn]=Jn.texture,Ot.min[Cn]=Jn.boundingBox.min,Ot.max[Cn]=Jn.boundingBox.max,Ot.resolution[Cn]=Jn.resolution,Cn++);for(let Jn in Ot)Ot[Jn].length=Cn;pn.probesSH.value=Ot.textures,pn.probesMin.value=Ot.min,pn.probesMax.value=Ot.max,pn.probesResolution.value=Ot.resolution}aa.upload(B,qs(Oe),pn,Ze)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(aa.upload(B,qs(Oe),pn,Ze),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&dt.setValue(B,"center",K.center),dt.setValue(B,"modelViewMatrix",K.modelViewMatrix),dt.setValue(B,"normalMatrix",K.normalMatrix),dt.setValue(B,"modelMatrix",K.matrixWorld),Z.uniformsGroups!==void 0){let Ot=Z.uniformsGroups;for(let Cn=0,Jn=Ot.length;Cn<Jn;Cn++){let Pl=Ot[Cn];qe.update(Pl,An),qe.bind(Pl,An)}}return An}function so(A,V){A.ambientLightColor.needsUpdate=V,A.lightProbe.needsUpdate=V,A.sunLights.needsUpdate=V,A.sunLightShadows.needsUpdate=V,A.directionalLights.needsUpdate=V,A.directionalLightShadows.needsUpdate=V,A.pointLights.needsUpdate=V,A.pointLightShadows.needsUpdate=V,A.spotLights.needsUpdate=V,A.spotLightShadows.needsUpdate=V,A.rectAreaLights.needsUpdate=V,A.hemisphereLights.needsUpdate=V}function Ys(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(A,V,Q){let Z=We.get(A);Z.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),We.get(A.texture).__webglTexture=V,We.get(A.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:Q,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,V){let Q=We.get(A);Q.__webglFramebuffer=V,Q.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(A,V=0,Q=0){le=A,$=V,H=Q;let Z=null,K=!1,Ee=!1;if(A){let Te=We.get(A);if(Te.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(B.FRAMEBUFFER,Te.__webglFramebuffer),ie.copy(A.viewport),he.copy(A.scissor),de=A.scissorTest,Me.viewport(ie),Me.scissor(he),Me.setScissorTest(de),Y=-1;return}else if(Te.__webglFramebuffer===void 0)Ze.setupRenderTarget(A);else if(Te.__hasExternalTextures)Ze.rebindTextures(A,We.get(A.texture).__webglTexture,We.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let nt=A.depthTexture;if(Te.__boundDepthTexture!==nt){if(nt!==null&&We.has(nt)&&(A.width!==nt.image.width||A.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(A)}}let De=A.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ee=!0);let He=We.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(He[V])?Z=He[V][Q]:Z=He[V],K=!0):A.samples>0&&Ze.useMultisampledRTT(A)===!1?Z=We.get(A).__webglMultisampledFramebuffer:Array.isArray(He)?Z=He[Q]:Z=He,ie.copy(A.viewport),he.copy(A.scissor),de=A.scissorTest}else ie.copy(Xe).multiplyScalar(Se).floor(),he.copy(pt).multiplyScalar(Se).floor(),de=ht;if(Q!==0&&(Z=G),Me.bindFramebuffer(B.FRAMEBUFFER,Z)&&Me.drawBuffers(A,Z),Me.viewport(ie),Me.scissor(he),Me.setScissorTest(de),K){let Te=We.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+V,Te.__webglTexture,Q)}else if(Ee){let Te=V;for(let De=0;De<A.textures.length;De++){let He=We.get(A.textures[De]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+De,He.__webglTexture,Q,Te)}}else if(A!==null&&Q!==0){let Te=We.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Te.__webglTexture,Q)}Y=-1};function ro(A){let V=We.get(A);return(V.__readFormat!==A.format||V.__readType!==A.type)&&(V.__readFormat=A.format,V.__readType=A.type,V.__formatReadable=lt.textureFormatReadable(A.format),V.__typeReadable=lt.textureTypeReadable(A.type)),V}this.readRenderTargetPixels=function(A,V,Q,Z,K,Ee,Ie,Te=0){if(!(A&&A.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=We.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(De=De[Ie],Array.isArray(De)&&(De=De[0])),De){Me.bindFramebuffer(B.FRAMEBUFFER,De);try{let He=A.textures[Te],nt=He.format,gt=He.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let ze=ro(He);if(ze.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=A.width-Z&&Q>=0&&Q<=A.height-K&&B.readPixels(V,Q,Z,K,ge.convert(nt),ge.convert(gt),Ee)}finally{let He=le!==null?We.get(le).__webglFramebuffer:null;Me.bindFramebuffer(B.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(A,V,Q,Z,K,Ee,Ie,Te=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=We.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(De=De[Ie],Array.isArray(De)&&(De=De[0])),De)if(V>=0&&V<=A.width-Z&&Q>=0&&Q<=A.height-K){Me.bindFramebuffer(B.FRAMEBUFFER,De);let He=A.textures[Te],nt=He.format,gt=He.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let ze=ro(He);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _t=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,_t),B.bufferData(B.PIXEL_PACK_BUFFER,Ee.byteLength,B.STREAM_READ),B.readPixels(V,Q,Z,K,ge.convert(nt),ge.convert(gt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let un=le!==null?We.get(le).__webglFramebuffer:null;Me.bindFramebuffer(B.FRAMEBUFFER,un);let Ft=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await sv(B,Ft,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,_t),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ee),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(_t),B.deleteSync(Ft),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,V=null,Q=0){let Z=Math.pow(2,-Q),K=Math.floor(A.image.width*Z),Ee=Math.floor(A.image.height*Z),Ie=V!==null?V.x:0,Te=V!==null?V.y:0;Ze.setTexture2D(A,0),B.copyTexSubImage2D(B.TEXTURE_2D,Q,0,0,Ie,Te,K,Ee),Me.unbindTexture()},this.copyTextureToTexture=function(A,V,Q=null,Z=null,K=0,Ee=0){let Ie,Te,De,He,nt,gt,ze,_t,un,Ft=A.isCompressedTexture?A.mipmaps[Ee]:A.image;if(Q!==null)Ie=Q.max.x-Q.min.x,Te=Q.max.y-Q.min.y,De=Q.isBox3?Q.max.z-Q.min.z:1,He=Q.min.x,nt=Q.min.y,gt=Q.isBox3?Q.min.z:0;else{let dt=Math.pow(2,-K);Ie=Math.floor(Ft.width*dt),Te=Math.floor(Ft.height*dt),A.isDataArrayTexture?De=Ft.depth:A.isData3DTexture?De=Math.floor(Ft.depth*dt):De=1,He=0,nt=0,gt=0}Z!==null?(ze=Z.x,_t=Z.y,un=Z.z):(ze=0,_t=0,un=0);let Ut=ge.convert(V.format),Nn=ge.convert(V.type),Oe;V.isData3DTexture?(Ze.setTexture3D(V,0),Oe=B.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Ze.setTexture2DArray(V,0),Oe=B.TEXTURE_2D_ARRAY):(Ze.setTexture2D(V,0),Oe=B.TEXTURE_2D),Me.activeTexture(B.TEXTURE0),Me.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,V.flipY),Me.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Me.pixelStorei(B.UNPACK_ALIGNMENT,V.unpackAlignment);let Tn=Me.getParameter(B.UNPACK_ROW_LENGTH),yt=Me.getParameter(B.UNPACK_IMAGE_HEIGHT),Ts=Me.getParameter(B.UNPACK_SKIP_PIXELS),An=Me.getParameter(B.UNPACK_SKIP_ROWS),oo=Me.getParameter(B.UNPACK_SKIP_IMAGES);Me.pixelStorei(B.UNPACK_ROW_LENGTH,Ft.width),Me.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Ft.height),Me.pixelStorei(B.UNPACK_SKIP_PIXELS,He),Me.pixelStorei(B.UNPACK_SKIP_ROWS,nt),Me.pixelStorei(B.UNPACK_SKIP_IMAGES,gt);let rs=A.isDataArrayTexture||A.isData3DTexture,As=V.isDataArrayTexture||V.isData3DTexture;if(A.isDepthTexture){let dt=We.get(A),pn=We.get(V),oi=We.get(dt.__renderTarget),Ot=We.get(pn.__renderTarget);Me.bindFramebuffer(B.READ_FRAMEBUFFER,oi.__webglFramebuffer),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ot.__webglFramebuffer);for(let Cn=0;Cn<De;Cn++)rs&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,We.get(A).__webglTexture,K,gt+Cn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,We.get(V).__webglTexture,Ee,un+Cn)),B.blitFramebuffer(He,nt,He+Ie,nt+Te,ze,_t,ze+Ie,_t+Te,B.DEPTH_BUFFER_BIT,B.NEAREST);Me.bindFramebuffer(B.READ_FRAMEBUFFER,null),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(K!==0||A.isRenderTargetTexture||We.has(A)){let dt=We.get(A),pn=We.get(V);Me.bindFramebuffer(B.READ_FRAMEBUFFER,N),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let oi=0;oi<De;oi++)rs?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,dt.__webglTexture,K,gt+oi):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,dt.__webglTexture,K),As?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,pn.__webglTexture,Ee,un+oi):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,pn.__webglTexture,Ee),K!==0?B.blitFramebuffer(He,nt,He+Ie,nt+Te,ze,_t,ze+Ie,_t+Te,B.COLOR_BUFFER_BIT,B.NEAREST):As?B.copyTexSubImage3D(Oe,Ee,ze,_t,un+oi,He,nt,Ie,Te):B.copyTexSubImage2D(Oe,Ee,ze,_t,He,nt,Ie,Te);Me.bindFramebuffer(B.READ_FRAMEBUFFER,null),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else As?A.isDataTexture||A.isData3DTexture?B.texSubImage3D(Oe,Ee,ze,_t,un,Ie,Te,De,Ut,Nn,Ft.data):V.isCompressedArrayTexture?B.compressedTexSubImage3D(Oe,Ee,ze,_t,un,Ie,Te,De,Ut,Ft.data):B.texSubImage3D(Oe,Ee,ze,_t,un,Ie,Te,De,Ut,Nn,Ft):A.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ee,ze,_t,Ie,Te,Ut,Nn,Ft.data):A.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ee,ze,_t,Ft.width,Ft.height,Ut,Ft.data):B.texSubImage2D(B.TEXTURE_2D,Ee,ze,_t,Ie,Te,Ut,Nn,Ft);Me.pixelStorei(B.UNPACK_ROW_LENGTH,Tn),Me.pixelStorei(B.UNPACK_IMAGE_HEIGHT,yt),Me.pixelStorei(B.UNPACK_SKIP_PIXELS,Ts),Me.pixelStorei(B.UNPACK_SKIP_ROWS,An),Me.pixelStorei(B.UNPACK_SKIP_IMAGES,oo),Ee===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&B.generateMipmap(Oe),Me.unbindTexture()},this.initRenderTarget=function(A){We.get(A).__webglFramebuffer===void 0&&Ze.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Ze.setTextureCube(A,0):A.isData3DTexture?Ze.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Ze.setTexture2DArray(A,0):Ze.setTexture2D(A,0),Me.unbindTexture()},this.resetState=function(){$=0,H=0,le=null,Me.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Vi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var ZA={depth:0,error:1,reason:2,oak:3},KA=`
precision highp float;
precision highp int;
precision highp usampler2D;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform usampler2D depth;
uniform usampler2D truth;
uniform usampler2D measured;
uniform usampler2D reasons;
uniform sampler2D table;
uniform vec2 tangent;
uniform vec2 range;
uniform int mode;
uniform int stride;
uniform bool isRelative;
uniform vec3 color;
uniform float pointSize;
in float unused;
out vec3 shade;

vec3 lookUp(float from0to1) {
  return texture(table, vec2((clamp(from0to1, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

void main() {
  ivec2 size = textureSize(depth, 0);
  int columns = size.x / stride;
  ivec2 pixel = ivec2(gl_VertexID % columns, gl_VertexID / columns) * stride;
  uint value = texelFetch(depth, pixel, 0).r;
  float z = float(value) * 0.001;
  vec2 place = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place * tangent * z, z, 1.0);
  gl_PointSize = pointSize;
  shade = color;
  bool isDropped = value == 0u;
  if (mode == 0) {
    shade = lookUp((z - range.x) / max(range.y - range.x, 1e-6));
  } else if (mode == 1) {
    uint exact = texelFetch(truth, pixel, 0).r;
    uint found = texelFetch(measured, pixel, 0).r;
    float error = (float(found) - float(exact)) * 0.001;
    if (isRelative) error *= 100.0 / max(float(exact) * 0.001, 1e-3);
    shade = found == 0u ? vec3(0.42) : lookUp(0.5 + 0.5 * error / max(range.y, 1e-9));
    isDropped = isDropped || exact == 0u;
  } else if (mode == 2) {
    shade = texelFetch(table, ivec2(int(texelFetch(reasons, pixel, 0).r), 0), 0).rgb;
  }
  if (isDropped) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`,JA=`
precision highp float;
in vec3 shade;
out vec4 result;
void main() {
  result = vec4(shade, 1.0);
}`;function QA(n){let e=n.format==="u16mm",t=new Wr(n.data,n.width,n.height,oa,e?Sr:Kn);return t.internalFormat=e?"R16UI":"R8UI",t.minFilter=t.magFilter=Ln,t.unpackAlignment=1,t.needsUpdate=!0,t}function Hv(n){let{width:e,height:t}=n.depth,i=Math.max(1,Math.ceil(Math.sqrt(e*t/n.maxPoints))),s=Math.floor(e/i)*Math.floor(t/i),r=new Nt;r.setAttribute("unused",new Zn(new Uint8Array(s),1)),r.setDrawRange(0,s);let o=new Map,a=d=>{let f=d??n.depth,g=o.get(f)??QA(f);return o.set(f,g),g},l=new Wr(n.table,n.table.length/4,1,Di,Kn);l.needsUpdate=!0;let c=d=>Math.tan(d*Math.PI/360),u=new ta({glslVersion:vl,vertexShader:KA,fragmentShader:JA,uniforms:{depth:{value:a(n.depth)},truth:{value:a(n.truth)},measured:{value:a(n.measured)},reasons:{value:a(n.reasons)},table:{value:l},tangent:{value:new ct(c(n.hfovDeg),c(n.vfovDeg))},range:{value:new ct(...n.range)},mode:{value:ZA[n.mode]},stride:{value:i},isRelative:{value:n.isRelative},color:{value:new U(...n.color)},pointSize:{value:n.pointSize}}});u.addEventListener("dispose",()=>{for(let d of o.values())d.dispose();l.dispose()});let h=new Xr(r,u);return h.frustumCulled=!1,h.matrixAutoUpdate=!1,h}function Wv(n){n.material.depthTest=!1,n.renderOrder=1}function Xv(n,e,t){n.matrix.multiplyMatrices(e,t),n.matrixWorldNeedsUpdate=!0}var jA=Float32Array.from({length:256},(n,e)=>{let t=e/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4});function qv(n,e){let t=new Uint8Array(n.header.vertices*4);n.indices.forEach((s,r)=>t.set(e(n.objects[Math.floor(r/3)]??0),s*4));let i=wl({...n,colors:t},!1);return i.material.polygonOffset=!0,i.material.polygonOffsetFactor=-2,i.material.polygonOffsetUnits=-4,i}function wl(n,e){let t=new Nt,{vertices:i}=n.header,s=new Float32Array(i*3);for(let o=0;o<i;o++)for(let a=0;a<3;a++)s[o*3+a]=jA[n.colors[o*4+a]??0]??0;t.setAttribute("position",new Zn(n.positions,3)),t.setAttribute("color",new Zn(s,3)),t.setIndex(new Zn(n.indices,1)),t.computeBoundingSphere();let r=e?ii:xs;return new Le(t,new $r({vertexColors:!0,flatShading:!0,side:r}))}var eC=.25,tC=150,Lh={minimum:"#e5484d",ideal:"#2fa36b",maximum:"#d9822b"};function $v(n){let e=new ti;if(e.add(nC(n)),n.showCameras)for(let t of n.model.cameras){let{hfovDeg:i,vfovDeg:s,bodyFromCamera:r}=t,o=Jv(i,s,eC,on(n.color),n.isSelected?.9:.45);e.add(Yv(o,r))}return n.showRanges&&n.sensor&&e.add(Yv(sC(n.sensor,n),n.sensor.bodyFromCamera)),e}function eo(n){n.traverse(e=>{let{geometry:t,material:i}=e;t?.dispose();for(let s of Array.isArray(i)?i:[i])s?.dispose()})}function Zv(n,e){n.position.set(...e.position),n.quaternion.set(...e.quaternion),n.updateMatrixWorld(!0)}function Ap(n){let[e=1,t=0,i=0,s=0,r=0,o=1,a=0,l=0,c=0,u=0,h=1,d=0]=n;return new Mt().set(e,t,i,s,r,o,a,l,c,u,h,d,0,0,0,1)}function Yv(n,e){return n.applyMatrix4(Ap(e)),n}function nC({model:n,body:e,color:t,isSelected:i}){let{size:s,centre:r}=n.body,o=new ti,a=new Zt(...s);e?o.add(wl(e,!1)):o.add(new Le(a,new $r({color:"#5b6470"})));let l=new gr(new el(a),new xi({color:on(t),transparent:!i,opacity:i?1:.6}));for(let c of e?[l]:[...o.children,l])c.position.set(...r);return o.add(l),o}function iC(n,e,t){let i=s=>Math.tan(Math.min(s,tC)*Math.PI/360)*t;return[i(n),i(e)]}function Kv(n,e,t){let[i,s]=iC(n,e,t);return[[-i,-s,t],[i,-s,t],[i,s,t],[-i,s,t]]}function Jv(n,e,t,i,s){let r=Kv(n,e,t),o=r.flatMap((l,c)=>[[0,0,0],l,l,r[(c+1)%4]]),a=new Nt().setAttribute("position",new mt(o.flat(),3));return new gr(a,new xi({color:new st(i),transparent:!0,opacity:s}))}function sC(n,{color:e,isSelected:t}){let i=new ti,{hfovDeg:s,vfovDeg:r,minimumM:o,idealM:a,maximumM:l}=n,c=a?.[1]??l??3;i.add(Jv(s,r,c,on(e),t?.55:.25));let u=[[o,Lh.minimum],[a?.[0]??null,Lh.ideal],[a?.[1]??null,Lh.ideal],[l,Lh.maximum]];if(t)for(let[h,d]of u)h!==null&&h>0&&i.add(...rC(s,r,h,d));return i}function rC(n,e,t,i){let s=Kv(n,e,t),r=new Nt().setAttribute("position",new mt(s.flat(),3)),o=r.clone().setIndex([0,1,2,0,2,3]),a=new ji({color:i,transparent:!0,opacity:.05,side:ii,depthWrite:!1});return[new Ka(r,new xi({color:i})),new Le(o,a)]}var to=new br,xn=new U,wr=new U,cn=new $t,Qv={X:new U(1,0,0),Y:new U(0,1,0),Z:new U(0,0,1)},Cp={type:"change"},jv={type:"mouseDown",mode:null},ex={type:"mouseUp",mode:null},tx={type:"objectChange"},Oh=class extends cl{constructor(e,t=null){super(void 0,t);let i=new Pp(this);this._root=i;let s=new Ip;this._gizmo=s,i.add(s);let r=new Lp;this._plane=r,i.add(r);let o=this;function a(E,S){let R=S;Object.defineProperty(o,E,{get:function(){return R!==void 0?R:S},set:function(C){R!==C&&(R=C,r[E]=C,s[E]=C,o.dispatchEvent({type:E+"-changed",value:C}),o.dispatchEvent(Cp))}}),o[E]=S,r[E]=S,s[E]=S}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new U,c=new U,u=new $t,h=new $t,d=new U,f=new $t,g=new U,y=new U,p=new U,m=0,v=new U;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",u),a("worldQuaternionStart",h),a("cameraPosition",d),a("cameraQuaternion",f),a("pointStart",g),a("pointEnd",y),a("rotationAxis",p),a("rotationAngle",m),a("eye",v),this._offset=new U,this._startNorm=new U,this._endNorm=new U,this._cameraScale=new U,this._parentPosition=new U,this._parentQuaternion=new $t,this._parentQuaternionInv=new $t,this._parentScale=new U,this._worldScaleStart=new U,this._worldQuaternionInv=new $t,this._worldScale=new U,this._positionStart=new U,this._quaternionStart=new $t,this._scaleStart=new U,this._getPointer=oC.bind(this),this._onPointerDown=lC.bind(this),this._onPointerHover=aC.bind(this),this._onPointerMove=cC.bind(this),this._onPointerUp=uC.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&to.setFromCamera(e,this.camera);let t=Rp(this._gizmo.picker[this.mode],to);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&to.setFromCamera(e,this.camera);let t=Rp(this._plane,to,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,jv.mode=this.mode,this.dispatchEvent(jv)}}pointerMove(e){let t=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&to.setFromCamera(e,this.camera);let o=Rp(this._plane,to,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(cn.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(xn),t.search("X")!==-1&&(xn.x=Math.round(xn.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(xn.y=Math.round(xn.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(xn.z=Math.round(xn.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(xn)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),wr.set(a,a,a)}else xn.copy(this.pointStart),wr.copy(this.pointEnd),xn.applyQuaternion(this._worldQuaternionInv),wr.applyQuaternion(this._worldQuaternionInv),wr.divide(xn),t.search("X")===-1&&(wr.x=1),t.search("Y")===-1&&(wr.y=1),t.search("Z")===-1&&(wr.z=1);s.scale.copy(this._scaleStart).multiply(wr),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(xn.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(xn.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(Qv[t]),xn.copy(Qv[t]),r==="local"&&xn.applyQuaternion(this.worldQuaternion),xn.cross(this.eye),xn.length()===0?l=!0:this.rotationAngle=this._offset.dot(xn.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(cn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(cn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Cp),this.dispatchEvent(tx)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(ex.mode=this.mode,this.dispatchEvent(ex)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Cp),this.dispatchEvent(tx),this.pointStart.copy(this.pointEnd))}getRaycaster(){return to}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function oC(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{let e=this.domElement.getBoundingClientRect(),t=this.viewport,i,s,r,o;return t!==null?(i=t.x,s=e.height-t.y-t.w,r=t.z,o=t.w):(i=0,s=0,r=e.width,o=e.height),{x:(n.clientX-e.left-i)/r*2-1,y:-(n.clientY-e.top-s)/o*2+1,button:n.button}}}function aC(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function lC(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function cC(n){this.enabled&&this.pointerMove(this._getPointer(n))}function uC(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function Rp(n,e,t){let i=e.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||t)return i[s];return!1}var Dh=new Qi,qt=new U(0,1,0),nx=new U(0,0,0),ix=new Mt,Nh=new $t,Uh=new $t,Ms=new U,kh=new Mt,Al=new U(1,0,0),no=new U(0,1,0),Cl=new U(0,0,1),Fh=new U,El=new U,Tl=new U,Pp=class extends ln{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){let t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),this.parent&&(kh.copy(this.parent.matrixWorld).invert(),kh.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}},Ip=class extends ln{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let e=new ji({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new xi({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=e.clone();i.opacity=.15;let s=t.clone();s.opacity=.5;let r=e.clone();r.color.setHex(16711680);let o=e.clone();o.color.setHex(65280);let a=e.clone();a.color.setHex(255);let l=e.clone();l.color.setHex(16711680),l.opacity=.5;let c=e.clone();c.color.setHex(65280),c.opacity=.5;let u=e.clone();u.color.setHex(255),u.opacity=.5;let h=e.clone();h.opacity=.25;let d=e.clone();d.color.setHex(16776960),d.opacity=.25;let f=e.clone();f.color.setHex(16776960);let g=e.clone();g.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:f,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:u,activeTransparent:d};let y=new qn(0,.04,.1,12);y.translate(0,.05,0);let p=new Zt(.08,.08,.08);p.translate(0,.04,0);let m=new Nt;m.setAttribute("position",new mt([0,0,0,1,0,0],3));let v=new qn(.0075,.0075,.5,3);v.translate(0,.25,0);function E(W,$){let H=new Gs(W,.0075,3,64,$*Math.PI*2);return H.rotateY(Math.PI/2),H.rotateX(Math.PI/2),H}function S(){let W=new Nt;return W.setAttribute("position",new mt([0,0,0,1,1,1],3)),W}let R={X:[[new Le(y,r),[.5,0,0],[0,0,-Math.PI/2]],[new Le(y,r),[-.5,0,0],[0,0,Math.PI/2]],[new Le(v,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new Le(y,o),[0,.5,0]],[new Le(y,o),[0,-.5,0],[Math.PI,0,0]],[new Le(v,o)]],Z:[[new Le(y,a),[0,0,.5],[Math.PI/2,0,0]],[new Le(y,a),[0,0,-.5],[-Math.PI/2,0,0]],[new Le(v,a),null,[Math.PI/2,0,0]]],XYZ:[[new Le(new _r(.1,0),h),[0,0,0]]],XY:[[new Le(new Zt(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Le(new Zt(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Le(new Zt(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},C={X:[[new Le(new qn(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Le(new qn(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Le(new qn(.2,0,.6,4),i),[0,.3,0]],[new Le(new qn(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Le(new qn(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Le(new qn(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new Le(new _r(.2,0),i)]],XY:[[new Le(new Zt(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Le(new Zt(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Le(new Zt(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},x={START:[[new Le(new _r(.01,2),s),null,null,null,"helper"]],END:[[new Le(new _r(.01,2),s),null,null,null,"helper"]],DELTA:[[new ni(S(),s),null,null,null,"helper"]],X:[[new ni(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new ni(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new ni(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},w={XYZE:[[new Le(E(.5,1),g),null,[0,Math.PI/2,0]]],X:[[new Le(E(.5,.5),r)]],Y:[[new Le(E(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new Le(E(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new Le(E(.75,1),d),null,[0,Math.PI/2,0]]]},O={AXIS:[[new ni(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},I={XYZE:[[new Le(new Yr(.25,10,8),i)]],X:[[new Le(new Gs(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new Le(new Gs(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new Le(new Gs(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new Le(new Gs(.75,.1,2,24),i)]]},D={X:[[new Le(p,r),[.5,0,0],[0,0,-Math.PI/2]],[new Le(v,r),[0,0,0],[0,0,-Math.PI/2]],[new Le(p,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new Le(p,o),[0,.5,0]],[new Le(v,o)],[new Le(p,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new Le(p,a),[0,0,.5],[Math.PI/2,0,0]],[new Le(v,a),[0,0,0],[Math.PI/2,0,0]],[new Le(p,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new Le(new Zt(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Le(new Zt(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Le(new Zt(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Le(new Zt(.1,.1,.1),h)]]},z={X:[[new Le(new qn(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Le(new qn(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Le(new qn(.2,0,.6,4),i),[0,.3,0]],[new Le(new qn(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Le(new qn(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Le(new qn(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new Le(new Zt(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Le(new Zt(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Le(new Zt(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Le(new Zt(.2,.2,.2),i),[0,0,0]]]},G={X:[[new ni(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new ni(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new ni(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function N(W){let $=new ln;for(let H in W)for(let le=W[H].length;le--;){let Y=W[H][le][0].clone(),j=W[H][le][1],ie=W[H][le][2],he=W[H][le][3],de=W[H][le][4];Y.name=H,Y.tag=de,j&&Y.position.set(j[0],j[1],j[2]),ie&&Y.rotation.set(ie[0],ie[1],ie[2]),he&&Y.scale.set(he[0],he[1],he[2]),Y.updateMatrix();let ee=Y.geometry.clone();ee.applyMatrix4(Y.matrix),Y.geometry=ee,Y.renderOrder=1/0,Y.position.set(0,0,0),Y.rotation.set(0,0,0),Y.scale.set(1,1,1),$.add(Y)}return $}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=N(R)),this.add(this.gizmo.rotate=N(w)),this.add(this.gizmo.scale=N(D)),this.add(this.picker.translate=N(C)),this.add(this.picker.rotate=N(I)),this.add(this.picker.scale=N(z)),this.add(this.helper.translate=N(x)),this.add(this.helper.rotate=N(O)),this.add(this.helper.scale=N(G)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Uh;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(cn.setFromEuler(Dh.set(0,0,0)),o.quaternion.copy(i).multiply(cn),Math.abs(qt.copy(Al).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(cn.setFromEuler(Dh.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(cn),Math.abs(qt.copy(no).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(cn.setFromEuler(Dh.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(cn),Math.abs(qt.copy(Cl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(cn.setFromEuler(Dh.set(0,Math.PI/2,0)),qt.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(ix.lookAt(nx,qt,no)),o.quaternion.multiply(cn),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),xn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),xn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(xn),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(qt.copy(Al).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(qt.copy(no).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(qt.copy(Cl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(qt.copy(Cl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(qt.copy(Al).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(qt.copy(no).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(Nh.copy(i),qt.copy(this.eye).applyQuaternion(cn.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(ix.lookAt(this.eye,nx,no)),o.name==="X"&&(cn.setFromAxisAngle(Al,Math.atan2(-qt.y,qt.z)),cn.multiplyQuaternions(Nh,cn),o.quaternion.copy(cn)),o.name==="Y"&&(cn.setFromAxisAngle(no,Math.atan2(qt.x,qt.z)),cn.multiplyQuaternions(Nh,cn),o.quaternion.copy(cn)),o.name==="Z"&&(cn.setFromAxisAngle(Cl,Math.atan2(qt.y,qt.x)),cn.multiplyQuaternions(Nh,cn),o.quaternion.copy(cn))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}},Lp=class extends Le{constructor(){super(new qr(1e5,1e5,2,2),new ji({visible:!1,wireframe:!0,side:ii,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),Fh.copy(Al).applyQuaternion(t==="local"?this.worldQuaternion:Uh),El.copy(no).applyQuaternion(t==="local"?this.worldQuaternion:Uh),Tl.copy(Cl).applyQuaternion(t==="local"?this.worldQuaternion:Uh),qt.copy(El),this.mode){case"translate":case"scale":switch(this.axis){case"X":qt.copy(this.eye).cross(Fh),Ms.copy(Fh).cross(qt);break;case"Y":qt.copy(this.eye).cross(El),Ms.copy(El).cross(qt);break;case"Z":qt.copy(this.eye).cross(Tl),Ms.copy(Tl).cross(qt);break;case"XY":Ms.copy(Tl);break;case"YZ":Ms.copy(Fh);break;case"XZ":qt.copy(Tl),Ms.copy(El);break;case"XYZ":case"E":Ms.set(0,0,0);break}break;default:Ms.set(0,0,0)}Ms.length()===0?this.quaternion.copy(this.cameraQuaternion):(kh.lookAt(xn.set(0,0,0),Ms,qt),this.quaternion.setFromRotationMatrix(kh)),super.updateMatrixWorld(e)}};var Bh=class{controls;handle=new ln;constructor(e,t,i,s,r,o){this.controls=new Oh(e,t),this.controls.setSize(.7),i.add(this.handle,this.controls.getHelper()),this.controls.addEventListener("change",o),this.controls.addEventListener("dragging-changed",({value:a})=>{s.isEnabled=!a}),this.controls.addEventListener("objectChange",()=>{let{x:a,y:l,z:c}=this.handle.position,{x:u,y:h,z:d,w:f}=this.handle.quaternion;r({position:[a,l,c],quaternion:[u,h,d,f]})})}get isActive(){return this.controls.dragging||this.controls.axis!==null}set(e,t){if(e==="none"||!t){this.controls.detach();return}this.controls.setMode(e),this.controls.setSpace(e==="translate"?"world":"local"),this.controls.dragging||(this.handle.position.set(...t.position),this.handle.quaternion.set(...t.quaternion),this.handle.updateMatrixWorld()),this.controls.object!==this.handle&&this.controls.attach(this.handle)}};var hC=.02,sx=.01,ca=6,rx="#d6409f",dC="#ffffff",zh=class{constructor(e,t,i,s,r,o){this.canvas=e;this.navigation=i;this.ray=s;this.onBox=r;this.onChange=o;this.handles=Array.from({length:ca+1},(a,l)=>{let c=new ji({color:rx,depthTest:!1,transparent:!0,opacity:.9}),u=new Le(l===ca?new Yr(.75,16,12):new Zt(1,1,1),c);return u.renderOrder=11,u}),this.group.add(...this.handles),this.group.visible=!1,t.add(this.group),e.addEventListener("pointermove",a=>this.hover(a)),e.addEventListener("pointerdown",a=>this.grab(a))}canvas;navigation;ray;onBox;onChange;group=new ti;handles;box=null;up="z";hovered=-1;drag=null;get isActive(){return this.hovered>=0||this.drag!==null}set(e,t){this.box=e,this.up=t,this.group.visible=e!==null,e||(this.hovered=-1),this.handles.forEach((i,s)=>e&&i.position.copy(ax(e,s)))}fit(e){if(this.box)for(let t of this.handles)t.scale.setScalar(hC*e.position.distanceTo(t.position))}find(e){if(!this.box)return-1;let t=this.ray(e.clientX,e.clientY).intersectObjects(this.handles);return this.handles.findIndex(i=>i===t[0]?.object)}hover(e){if(this.drag||e.buttons!==0)return;let t=this.find(e);t!==this.hovered&&(this.hovered=t,this.canvas.style.cursor=t>=0?"grab":"",this.handles.forEach((i,s)=>i.material.color.set(s===t?dC:rx)),this.onChange())}grab(e){let t=e.button===0?this.find(e):-1;if(t<0||!this.box)return;let i={handle:t,box:this.box,from:new U,isVertical:e.shiftKey},s=this.reach(e,i);if(!s)return;this.drag={...i,from:s},this.navigation.isEnabled=!1;let r=a=>this.move(a),o=()=>{this.drag=null,this.navigation.isEnabled=!0,removeEventListener("pointermove",r),removeEventListener("pointerup",o),removeEventListener("pointercancel",o)};addEventListener("pointermove",r),addEventListener("pointerup",o),addEventListener("pointercancel",o)}move(e){let{drag:t}=this,i=t&&this.reach(e,t);if(!t||!i)return;let s=i.sub(t.from).toArray(),r=[[...t.box[0]],[...t.box[1]]];if(t.handle===ca)for(let o of r)o.forEach((a,l)=>o[l]=a+(s[l]??0));else{let[o,a]=[t.handle>>1,t.handle&1],[l,c]=[t.box[0][o]??0,t.box[1][o]??0],u=(a?c:l)+(s[o]??0);r[a][o]=a?Math.max(u,l+sx):Math.min(u,c-sx)}this.onBox(r.map(o=>o.map(a=>Number(a.toFixed(4)))))}reach(e,{handle:t,box:i,isVertical:s}){let{ray:r}=this.ray(e.clientX,e.clientY),o=ax(i,t),a=this.up==="z"?2:1;return t!==ca||s?fC(r.origin,r.direction,o,ox(t===ca?a:t>>1)):r.intersectPlane(new fi().setFromNormalAndCoplanarPoint(ox(a),o),new U)}};function ox(n){return new U().setComponent(n,1)}function ax([n,e],t){let i=new U(...n).add(new U(...e)).multiplyScalar(.5);return t!==ca&&i.setComponent(t>>1,(t&1?e:n)[t>>1]??0),i}function fC(n,e,t,i){let s=n.clone().sub(t),r=i.dot(e),o=1-r*r;if(o<1e-4)return null;let a=(i.dot(s)-r*e.dot(s))/o;return t.clone().addScaledVector(i,a)}var Vh=.006,pC=1.0015,Gh=Math.PI/2-.02,lx={KeyW:[1,0,0],KeyS:[-1,0,0],KeyA:[0,1,0],KeyD:[0,-1,0],KeyE:[0,0,1],KeyQ:[0,0,-1]},Hh=class{constructor(e,t,i){this.camera=e;this.element=t;this.onChange=i;t.addEventListener("pointerdown",s=>this.grab(s)),t.addEventListener("wheel",s=>this.zoom(s),{passive:!1}),t.addEventListener("contextmenu",s=>s.preventDefault()),t.addEventListener("keydown",s=>this.press(s)),t.addEventListener("keyup",s=>this.keys.delete(s.code)),t.addEventListener("blur",()=>this.keys.clear())}camera;element;onChange;isEnabled=!0;up="z";target=new U;distance=5;azimuth=0;elevation=.4;keys=new Set;isFast=!1;lastTime=0;look(e,t,i){this.up=e,this.camera.up.copy(this.world(0,0,1)),this.target.copy(t);let s=i.clone().sub(t);this.distance=Math.max(s.length(),.05);let[r,o,a]=this.local(s.normalize());this.azimuth=Math.atan2(o,r),this.elevation=Math.asin(Math.max(-1,Math.min(1,a))),this.apply()}lookAlong(e){let t=new U(...e.position),i=new U(...Ca(e.quaternion,[1,0,0]));this.look(this.up,t.clone().addScaledVector(i,2),t)}focus(e,t){this.target.copy(e),this.distance=t,this.apply()}world(e,t,i){return this.up==="z"?new U(e,t,i):new U(e,i,-t)}local({x:e,y:t,z:i}){return this.up==="z"?[e,t,i]:[e,-i,t]}outward(){let e=Math.cos(this.elevation);return this.world(e*Math.cos(this.azimuth),e*Math.sin(this.azimuth),Math.sin(this.elevation))}apply(){this.elevation=Math.max(-Gh,Math.min(Gh,this.elevation)),this.camera.position.copy(this.target).addScaledVector(this.outward(),this.distance),this.camera.lookAt(this.target),this.camera.updateMatrixWorld(),this.onChange()}grab(e){if(!this.isEnabled)return;this.element.focus({preventScroll:!0});let t=e.button!==0||e.shiftKey,i=e.ctrlKey||e.altKey,[s,r]=[e.clientX,e.clientY],o=l=>{if(!this.isEnabled)return;let[c,u]=[l.clientX-s,l.clientY-r];[s,r]=[l.clientX,l.clientY],t?this.pan(c,u):i?this.turnHead(c,u):this.orbit(c,u)},a=()=>{removeEventListener("pointermove",o),removeEventListener("pointerup",a),removeEventListener("pointercancel",a)};addEventListener("pointermove",o),addEventListener("pointerup",a),addEventListener("pointercancel",a)}orbit(e,t){this.azimuth-=e*Vh,this.elevation+=t*Vh,this.apply()}turnHead(e,t){let i=this.camera.position.clone();this.azimuth-=e*Vh*.5,this.elevation=Math.max(-Gh,Math.min(Gh,this.elevation+t*Vh*.5)),this.target.copy(i).addScaledVector(this.outward(),-this.distance),this.apply()}pan(e,t){let i=2*this.distance*Math.tan(this.camera.fov*Math.PI/360)/this.element.clientHeight,s=new U().setFromMatrixColumn(this.camera.matrixWorld,0),r=new U().setFromMatrixColumn(this.camera.matrixWorld,1);this.target.addScaledVector(s,-e*i).addScaledVector(r,t*i),this.apply()}zoom(e){e.preventDefault();let t=e.deltaMode===WheelEvent.DOM_DELTA_LINE?30:1;this.distance=Math.min(500,Math.max(.05,this.distance*pC**(e.deltaY*t))),this.apply()}press(e){if(this.isFast=e.shiftKey,e.ctrlKey||e.metaKey||e.altKey||!(e.code in lx))return;e.preventDefault();let t=this.keys.size===0;this.keys.add(e.code),t&&(this.lastTime=performance.now(),requestAnimationFrame(()=>this.fly()))}fly(){if(this.keys.size===0)return;let e=performance.now(),t=Math.min((e-this.lastTime)/1e3,.1);this.lastTime=e;let i=Math.max(.4,this.distance*.6)*(this.isFast?3:1)*t,s=this.outward().negate(),r=new U().setFromMatrixColumn(this.camera.matrixWorld,0);for(let o of this.keys){let[a,l,c]=lx[o]??[0,0,0];this.target.addScaledVector(s,a*i).addScaledVector(r,-l*i).add(this.world(0,0,c*i))}this.apply(),requestAnimationFrame(()=>this.fly())}};var mC=.03,cx="#ff2d78",gC=4,Wh=class{constructor(e,t){this.canvas=e;this.renderer=new Rh({canvas:e,antialias:!1,powerPreference:"high-performance"}),this.renderer.localClippingEnabled=!0,this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.scene.add(new il("#ffffff","#8a8f98",1.9),this.lamp,this.oaks,this.clouds);let i=()=>this.invalidate();this.navigation=new Hh(this.camera,e,()=>{this.invalidate(),t.onView()}),this.gizmo=new Bh(this.camera,e,this.scene,this.navigation,t.onPose,i);let s=(r,o)=>this.caster(r,o);this.box=new zh(e,this.scene,this.navigation,s,t.onBox,i),this.marker=new Xr(new Nt().setAttribute("position",new mt([0,0,0],3)),new ea({color:cx,size:9,sizeAttenuation:!1,depthTest:!1,transparent:!0})),this.sight=new ni(new Nt().setAttribute("position",new mt([0,0,0,0,0,0],3)),new xi({color:cx,transparent:!0,opacity:.7,depthTest:!1}));for(let r of[this.marker,this.sight])r.visible=!1,r.frustumCulled=!1,r.renderOrder=10,this.scene.add(r);this.observer=new ResizeObserver(()=>this.resize()),this.observer.observe(e),this.listenForClicks(t)}canvas;drawn=0;pace=0;navigation;gizmo;renderer;scene=new Ya;camera=new pi(50,1,.02,1e3);oaks=new ti;clouds=new ti;marker;sight;lamp=new ol("#ffffff",1.6);observer;mesh=null;grid=null;target=null;painting=null;box;objects=null;isWaiting=!1;lastDraw=0;close(){this.observer.disconnect(),eo(this.scene),this.renderer.dispose()}invalidate(){if(this.isWaiting)return;this.isWaiting=!0;let e=this.lastDraw+this.pace-performance.now();e>0?setTimeout(()=>this.draw(),e):this.draw()}get isSoftware(){let e=this.renderer.getContext(),t=e.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|softpipe|basic render/i.test(String(e.getParameter(t?t.UNMASKED_RENDERER_WEBGL:e.RENDERER)))}draw(){requestAnimationFrame(()=>{this.isWaiting=!1,this.lastDraw=performance.now(),this.lamp.position.copy(this.camera.position),this.box.fit(this.camera),this.renderer.render(this.scene,this.camera),this.drawn++})}get isIdle(){return!this.isWaiting}setBackground(e,t){this.scene.background=new st(e),this.grid&&this.grid.material.color.set(t),this.invalidate()}setScene(e,t,i){this.mesh&&(this.scene.remove(this.mesh),eo(this.mesh)),this.mesh=wl(t,i),this.objects=t.objects,this.scene.add(this.mesh);let s=new U(...e.bounds[1]).distanceTo(new U(...e.bounds[0]));this.camera.near=Math.min(.05,Math.max(s/5e3,.001)),this.camera.far=Math.max(100,s*10),this.camera.updateProjectionMatrix(),this.invalidate()}showScene(e){this.mesh&&(this.mesh.visible=e),this.invalidate()}roofAbove(e,t){if(!this.mesh)return null;let i=new U(...uc(e.up)),s=new br(new U(...t),i).intersectObject(this.mesh)[0];return s?s.point.dot(i):null}setRoof(e,t){if(!this.mesh)return;let i=new U(...uc(e.up)).negate();this.mesh.material.clippingPlanes=t===null?null:[new fi(i,t-mC)],this.painting&&(this.painting.material.clippingPlanes=this.mesh.material.clippingPlanes),this.invalidate()}setGrid(e,t,i){if(this.grid&&(this.scene.remove(this.grid),eo(this.grid),this.grid=null),t){let[s,r]=e.bounds,[o,a]=e.up==="z"?[r[0]-s[0],r[1]-s[1]]:[r[0]-s[0],r[2]-s[2]],l=Math.min(100,Math.max(4,2*Math.ceil(Math.max(o,a)/2)+2));this.grid=new al(l,l,i,i),e.up==="z"&&(this.grid.rotation.x=Math.PI/2);let c=new U(...s).add(new U(...r)).multiplyScalar(.5).round();e.up==="z"?c.z=s[2]-.01:c.y=s[1]-.01,this.grid.position.copy(c),this.scene.add(this.grid)}this.invalidate()}setOaks(e){eo(this.oaks),this.oaks.clear(),e.length&&this.oaks.add(...e),this.invalidate()}setClouds(e){eo(this.clouds),this.clouds.clear(),e.length&&this.clouds.add(...e),this.invalidate()}setMarker(e,t){if(this.marker.visible=e!==null,this.sight.visible=e!==null&&t!==null,e&&this.marker.position.set(...e),e&&t){let i=this.sight.geometry.getAttribute("position");i.setXYZ(0,...t),i.setXYZ(1,...e),i.needsUpdate=!0}this.invalidate()}setPainting(e,t){this.painting&&(this.scene.remove(this.painting),eo(this.painting),this.painting=null),e&&(this.painting=qv(e,t),this.painting.material.clippingPlanes=this.mesh?.material.clippingPlanes??null,this.scene.add(this.painting)),this.invalidate()}setTarget(e,t,i){if(this.box.set(t?e:null,i),this.target&&(this.scene.remove(this.target),this.target.dispose(),this.target=null),e){let s=new gs(new U(...e[0]),new U(...e[1]));this.target=new ll(s,new st("#d6409f")),this.scene.add(this.target)}this.invalidate()}setGizmo(e,t){this.gizmo.set(e,t),this.invalidate()}lookAt(e,t,i){let s=new U(...uc(e.up)),[r,o]=[new U(...e.bounds[0]),new U(...e.bounds[1])],a=new U(...t.position),l=Math.min(Math.max(r.distanceTo(o),1),8),c=new U(1,0,0).applyQuaternion(this.oaks.quaternion.clone().set(...t.quaternion));c.addScaledVector(s,-c.dot(s)),c.length()<.1&&c.set(1,0,0),c.normalize();let u=new U().crossVectors(s,c),h=a.clone().addScaledVector(c,l*.2),[d,f,g]=i?[.12,.12,.62]:[.3,.22,.25],y=a.clone().addScaledVector(c,-l*d).addScaledVector(u,-l*f).addScaledVector(s,l*g);this.navigation.look(e.up,h,y)}pose(){let e=new Mt().makeBasis(new U(0,0,-1),new U(-1,0,0),new U(0,1,0)),{x:t,y:i,z:s,w:r}=this.camera.quaternion.clone().multiply(new $t().setFromRotationMatrix(e));return{position:this.camera.position.toArray(),quaternion:[t,i,s,r]}}hit(e,t){if(!this.mesh?.visible)return null;let i=this.mesh.material.clippingPlanes??[],r=this.caster(e,t).intersectObject(this.mesh).find(({point:o})=>i.every(a=>a.distanceToPoint(o)>=0));return!r||r.faceIndex==null?null:{point:r.point,object:this.objects?.[r.faceIndex]??0}}caster(e,t){let{left:i,top:s,width:r,height:o}=this.canvas.getBoundingClientRect(),a=new br;return a.setFromCamera(new ct((e-i)/r*2-1,1-(t-s)/o*2),this.camera),a}oakAt(e,t,i){let s=this.caster(e,t),r=i?s.ray.origin.distanceTo(i):Number.POSITIVE_INFINITY,o=this.oaks.children.map(c=>c.children[0]).filter(c=>c!==void 0),a=s.intersectObjects(o).find(({object:c,distance:u})=>c.isMesh&&u<r),l=o.findIndex(c=>a&&(c===a.object||c===a.object.parent));return l<0?null:l}listenForClicks({onPick:e,onOak:t}){let i=null;this.canvas.addEventListener("pointerdown",s=>{i=s.button===0&&!this.gizmo.isActive&&!this.box.isActive?[s.clientX,s.clientY]:null}),this.canvas.addEventListener("pointerup",s=>{if(!i||Math.hypot(s.clientX-i[0],s.clientY-i[1])>gC)return;let r=this.hit(s.clientX,s.clientY),o=this.oakAt(s.clientX,s.clientY,r?.point??null);o===null?e(r?.object??null):t(o)}),this.canvas.addEventListener("dblclick",s=>{let r=this.hit(s.clientX,s.clientY);r&&this.navigation.focus(r.point,Math.max(.3,this.camera.position.distanceTo(r.point)*.5))})}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.invalidate())}};var _C=400,ux={mesh:null,error:null},Xh=class extends Bt{constructor(t){super(ux);this.studio=t;for(let i of[t.document,t.display,t.connection,t.scene])i.subscribe(()=>this.follow());this.follow()}studio;wanted=[];running=null;timer=0;get isIdle(){return this.timer===0&&this.running===null}follow(){let{document:t,display:i,connection:s,scene:r}=this.studio,{target:o,scene:a}=t.get(),l=Fn(t.get()),u=i.get().paintsCoverage&&o!==null&&l!==void 0&&this.studio.hasDepth(l.state)&&r.get()?.id===a&&s.get()==="open"?[a,o,l.state]:[];u.length===this.wanted.length&&u.every((h,d)=>h===this.wanted[d])||(this.wanted=u,this.running?.abort(),this.running=null,clearTimeout(this.timer),this.timer=0,l&&u.length?this.timer=window.setTimeout(()=>{this.paint(l)},_C):this.set(ux))}async paint(t){this.timer=0;let{scene:i,target:s}=this.studio.document.get();if(!s)return;let r=new AbortController;this.running=r;try{let o=await hn.surface({scene:i,state:t.state,region:s},r.signal);this.running===r&&this.set({mesh:o,error:null})}catch(o){this.running===r&&this.set({mesh:null,error:o instanceof Error?o.message:String(o)})}finally{this.running===r&&(this.running=null)}}};var vC=1e5,xC=5e6,yC=3e5,bC=150,SC=30,qh=class{constructor(e,t){this.studio=e;this.viewer=new Wh(t,{onPose:l=>this.movePose(l),onPick:l=>this.pick(l),onOak:l=>this.select(l),onView:()=>this.ride(),onBox:([l,c])=>e.document.commit("target box",u=>({...u,target:{minimum:l,maximum:c}}))}),this.painting=new Xh(e),this.painting.subscribe(()=>this.viewer.setPainting(this.painting.get().mesh,ya));let{document:i,display:s,scene:r,frames:o,probe:a}=e;r.subscribe(()=>{this.loadScene()});for(let l of[i,s,this.gizmo,this.isRiding])l.subscribe(()=>this.follow());o.subscribe(()=>this.followClouds()),a.subscribe(()=>this.followProbe()),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.paintBackground()),this.follow(),this.loadScene()}studio;gizmo=new Bt("translate");isPicking=new Bt(!1);isRiding=new Bt(!1);detail=new Bt(null);viewer;painting;bodies=new Map;groups=[];seen=new Map;hasClouds=!1;mesh=null;loaded="";wantsDetail=!1;ridden=0;roof=null;get isIdle(){return this.viewer.isIdle&&this.painting.isIdle}home(){let[e,t]=[this.studio.scene.get(),Fn(this.studio.document.get())];e&&t&&this.viewer.lookAt(e,t.state.pose,this.roof!==null&&!this.studio.display.get().showRoof)}lookThrough(){let e=Fn(this.studio.document.get());e&&this.viewer.navigation.lookAlong(e.state.pose)}setRiding(e){e&&this.lookThrough(),this.viewer.pace=e&&this.viewer.isSoftware?bC:0,this.isRiding.set(e)}loadFullDetail(){this.wantsDetail=!0,this.loaded="",this.loadScene()}paintBackground(){let e=getComputedStyle(document.documentElement),{scene:t,display:i}=this.studio,s=e.getPropertyValue("--grid").trim();this.viewer.setBackground(e.getPropertyValue("--view").trim(),s);let r=t.get();r&&this.viewer.setGrid(r,i.get().showGrid,s)}async loadScene(){let e=this.studio.scene.get();if(e||(this.loaded=""),!e||e.id===this.loaded)return;let t=this.isNew("place",e.id,...e.bounds.flat());this.loaded=e.id;try{let i=await hn.sceneMesh(e.id,this.wantsDetail?xC:vC);if(this.wantsDetail=!1,this.studio.scene.get()?.id!==e.id)return;this.viewer.setScene(e,i,!1),this.mesh=i,this.detail.set({shown:i.header.triangles,of:i.header.ofTriangles}),t&&(this.roof=this.viewer.roofAbove(e,e.pose.position)),t&&this.home(),this.follow()}catch(i){this.loaded="",this.studio.connection.get()==="open"&&this.studio.report("The 3D view",i)}}follow(){let{document:e,display:t,scene:i}=this.studio,[s,r,o]=[t.get(),e.get(),i.get()];this.followOaks(r.oaks,r.selected,s);let[a,l]=[this.isRiding.get()?"none":this.gizmo.get(),Fn(r)?.state.pose??null];this.isNew("gizmo",a,l)&&this.viewer.setGizmo(a,l),this.isNew("scene",this.mesh,s.showScene)&&this.viewer.showScene(s.showScene);let c=s.showRoof?null:this.roof;if(o&&this.isNew("roof",this.mesh,c)&&this.viewer.setRoof(o,c),this.isNew("target",r.target,o)){let u=r.target!==null&&"minimum"in r.target;this.viewer.setTarget(Dp(r.target,o),u,o?.up??"z")}this.isNew("background",o,s.showGrid,s.theme)&&this.paintBackground(),this.followClouds()}isNew(e,...t){let i=this.seen.get(e);return this.seen.set(e,t),!i||i.length!==t.length||t.some((s,r)=>s!==i[r])}followOaks(e,t,i){let s=e.filter(a=>!a.isHidden),r=this.isRiding.get(),o=JSON.stringify([t,r,i.showCameras,i.showRanges,s.map(({key:a,state:l})=>[a,l.model,l.sensor,this.bodies.get(l.model)?1:0]),e.map(({key:a})=>a)]);if(this.isNew("looks",o)&&(this.groups=s.flatMap(a=>this.makeGroup(a,e.indexOf(a),a.key===t,i)),this.viewer.setOaks(this.groups.map(({group:a})=>a))),!!this.isNew("poses",o,...s.map(({state:a})=>a.pose))){for(let a of this.groups){let l=e.find(({key:u})=>u===a.oak.key);l&&Zv(a.group,l.state.pose);let{arePosesLinked:c}=this.studio.document.get();a.group.visible=!r||a.oak.key!==t&&!c}this.viewer.invalidate()}}makeGroup(e,t,i,s){let r=this.studio.catalog.get(),o=_i(r,e.state.model);if(!o)return[];this.loadBody(o.name);let a=$v({model:o,sensor:ui(r,e.state),body:this.bodies.get(o.name)??null,color:Qn(t),isSelected:i,showCameras:s.showCameras,showRanges:s.showRanges});return[{oak:e,group:a}]}async loadBody(e){if(!this.bodies.has(e)){this.bodies.set(e,null);try{this.bodies.set(e,await hn.body(e)),this.follow()}catch{}}}followClouds(){let{studio:e}=this,t=e.display.get(),i=e.frames.get(),{depthMap:s,depthRange:r,errorRange:o,errorUnit:a,cloud:l,cloudColor:c}=t;if(l==="none"&&!this.hasClouds||!this.isNew("clouds",s,r,o,a,l,c,...i.values()))return;this.hasClouds=l!=="none";let u=e.document.get().oaks;this.viewer.setClouds(l==="none"?[]:[...i].flatMap(([h,d])=>this.makeClouds(d,u.findIndex(({key:f})=>f===h),t,i)))}makeClouds(e,t,i,s){let r=ui(this.studio.catalog.get(),e.state);if(!r)return[];let{pictures:o,header:a}=e,l=o.get("reference")??o.get("depth"),c=o.get("sensor"),u=i.cloudColor==="reason"?l:c,h=i.cloud==="both"?[l,c]:[i.cloud==="truth"?l:u],d=lc(s.values(),i),f=i.cloudColor,[g,y,p]=Qn(Math.max(t,0)),m=new Mt().compose(new U(...e.state.pose.position),new $t(...e.state.pose.quaternion),new U(1,1,1));return h.filter(v=>v!==void 0).map(v=>{let E=i.cloud==="both"&&v===l,S=Hv({depth:v,truth:l,measured:c,reasons:o.get("reason"),hfovDeg:a.hfovDeg,vfovDeg:a.vfovDeg,mode:E?"oak":f,table:f==="error"?go():f==="reason"?Hl():mo(i.depthMap),range:f==="error"?[0,d.error]:d.depth,isRelative:i.errorUnit==="%",color:E?[.62,.64,.68]:[g/255,y/255,p/255],pointSize:2,maxPoints:yC/(s.size*h.length)});return Xv(S,m,Ap(r.bodyFromCamera)),f==="error"&&v===c&&Wv(S),S})}followProbe(){let{probe:e,frames:t,catalog:i}=this.studio,s=e.get(),r=s&&t.get().get(s.oak),o=r&&ui(i.get(),r.state);if(!s?.point||!r||!o)return this.viewer.setMarker(null,null);let a=o.bodyFromCamera,l=new U(a[3],a[7],a[11]).applyQuaternion(new $t(...r.state.pose.quaternion));this.viewer.setMarker(s.point,l.add(new U(...r.state.pose.position)).toArray())}ride(){!this.isRiding.get()||this.ridden||(this.ridden=window.setTimeout(()=>{this.ridden=0,this.isRiding.get()&&this.movePose(this.viewer.pose())},SC))}movePose(e){this.studio.change("pose",t=>({...t,pose:e}))}select(e){let t=this.groups[e]?.oak.key;t&&this.studio.document.set({...this.studio.document.get(),selected:t})}pick(e){if(!this.isPicking.get())return;let t=e===null?void 0:this.studio.scene.get()?.objects[e];t&&(this.isPicking.set(!1),this.studio.document.commit("target",i=>({...i,target:{object:t.path}})))}};function Dp(n,e){if(!n)return null;if("minimum"in n)return[n.minimum,n.maximum];let t=e?.objects.filter(({path:s})=>s===n.object||s.startsWith(`${n.object}/`))??[],[i]=t;return i?t.reduce(([s,r],{bounds:o})=>[s.map((a,l)=>Math.min(a,o[0][l]??a)),r.map((a,l)=>Math.max(a,o[1][l]??a))],i.bounds):null}var Yh=60;function hx({from:n,to:e,count:t}){return t<=1?[n]:Array.from({length:t},(i,s)=>n+(e-n)*s/(t-1))}function $h(n,e){return n.pose.position[e==="z"?2:1]}function dx(n,e,t,i){return n.flatMap(({key:s,state:r})=>hx(e).flatMap(o=>hx(t).map(a=>{let l=dc(r.pose,[0,0,o-$h(r,i)],i),c=fc(l,{pitch:a-ds(l.quaternion,i).pitch},i);return{key:s,state:{...r,pose:c}}})))}function fx(n,e,t){let i=n.flatMap(({key:r,state:o},a)=>{let l=e[a];return l?[{key:r,state:o,heightM:$h(o,t),tiltDeg:ds(o.pose.quaternion,t).pitch,coverage:l}]:[]}),s=({coverage:r})=>r.medianAbsoluteErrorM??Number.POSITIVE_INFINITY;return i.sort((r,o)=>o.coverage.measured-r.coverage.measured||s(r)-s(o))}var MC=3,wC=12;function mx({target:n,tolerance:e}){let{studio:t}=Ve(),i=Ae(t.document),s=Ae(t.scene)?.up??"z",r=Fn(i),o=r?$h(r.state,s):1,[a,l]=Pt(()=>({from:Number((o-.5).toFixed(2)),to:Number((o+.5).toFixed(2)),count:5})),[c,u]=Pt(()=>{let w=r?Math.round(ds(r.state.pose.quaternion,s).pitch):0;return{from:w-20,to:w+20,count:3}}),[h,d]=Pt(!1),[f,g]=Pt(null),[y,p]=Pt(null),m=Tt(null),[v,E]=Pt(null);if(Gt(()=>()=>m.current?.abort(),[]),Gt(()=>{m.current?.abort(),g(null),p(null)},[i.scene,JSON.stringify(n),e]),!r)return null;let S=h?i.oaks.filter(w=>!w.isHidden&&t.hasDepth(w.state)):[r],R=a.count*c.count*S.length,C=async()=>{let w=dx(S,a,c,s),O=new AbortController;m.current=O,p(null);let I=[];try{for(;I.length<w.length;){E(I.length);let D=w.slice(I.length,I.length+MC).map(({state:z})=>z);I.push(...(await hn.coverage({scene:i.scene,states:D,region:n,toleranceMm:e},O.signal)).poses),g(fx(w,I,s))}}catch(D){O.signal.aborted||p(D instanceof Error?D.message:String(D))}finally{E(null)}},x=({key:w,state:O})=>t.document.commit("sweep",I=>nr({...I,selected:w},w,D=>({...D,pose:O.pose})));return _(en,{title:"Sweep",testId:"sweep",children:[_(px,{name:"Height",unit:"m",span:a,onChange:l}),_(px,{name:"Tilt",unit:"°",span:c,onChange:u}),i.oaks.length>1&&_(Oi,{label:"All models, not only the selected OAK",isOn:h,onChange:d}),_("div",{class:"row",children:[v!==null?_(Ge,{label:"Cancel",onClick:()=>m.current?.abort()}):_(Ge,{label:`Try ${R} poses`,class:"primary",isDisabled:R>Yh,onClick:()=>{C()},testId:"run-sweep"}),v!==null&&_("span",{class:"hint",role:"status",children:`${v} of ${R}`}),R>Yh&&_("span",{class:"problem",children:`At most ${Yh} poses.`})]}),y&&_("p",{class:"problem",role:"alert",children:y}),f&&_("div",{class:"scroll-x",children:_(EC,{ranked:f.slice(0,wC),onTake:x})})]})}function px({name:n,unit:e,span:t,onChange:i}){let[s,r]=e==="m"?[.1,2]:[5,1];return _("div",{class:"triple",children:[_(Mn,{label:`${n} from`,value:t.from,unit:e,step:s,digits:r,onChange:o=>i({...t,from:o})}),_(Mn,{label:"to",value:t.to,unit:e,step:s,digits:r,onChange:o=>i({...t,to:o})}),_(Mn,{label:"steps",value:t.count,step:1,digits:0,minimum:1,maximum:20,onChange:o=>i({...t,count:Math.round(o)})})]})}function EC({ranked:n,onTake:e}){let t=new Set(n.map(({state:i})=>i.model)).size>1;return _("table",{class:"numbers ranking",children:[_("thead",{children:_("tr",{children:[t&&_("th",{scope:"col",children:"OAK"}),_("th",{scope:"col",children:"Height"}),_("th",{scope:"col",children:"Tilt"}),_("th",{scope:"col",children:"Measured"}),_("th",{scope:"col","data-tip":"The share of what the camera sees there that it measures",children:"of seen"}),_("th",{scope:"col",children:"|Error|"}),_("td",{})]})}),_("tbody",{children:n.map((i,s)=>_("tr",{children:[t&&_("td",{class:"model",children:i.state.model}),_("td",{children:[i.heightM.toFixed(2)," m"]}),_("td",{children:[i.tiltDeg.toFixed(0),"°"]}),_("td",{children:Lr(i.coverage.measured)}),_("td",{children:i.coverage.seen>0?Lr(i.coverage.measured/i.coverage.seen):"–"}),_("td",{children:jm(i.coverage.medianAbsoluteErrorM)}),_("td",{children:_(Ge,{label:"Take",class:"text",tip:"Move this OAK there",onClick:()=>e(i)})})]},s))})]})}function gx(){let{studio:n}=Ve(),{target:e}=Ae(n.document),{toleranceMm:t}=Ae(n.display);return _(xt,{children:[_(TC,{target:e}),e&&_(IC,{target:e,tolerance:t}),e&&_(mx,{target:e,tolerance:t})]})}function TC({target:n}){let{studio:e,view:t}=Ve(),i=Ae(e.scene),s=l=>e.document.commit("target",c=>({...c,target:l})),r=Dp(n,i),o=Ir(()=>qm(i?.objects.map(({path:l})=>l)??[]),[i]),a=()=>{let[l,c]=r??AC(i);s({minimum:l,maximum:c})};return _(en,{title:"Region",testId:"region",children:[_("p",{class:"hint",children:"Which part of the scene must be measured? Choose an object, or a box."}),_("label",{class:"field",children:[_("span",{class:"sr-only",children:"Object"}),_("select",{"data-testid":"target",value:n&&"object"in n?n.object:"",onChange:l=>s(l.currentTarget.value?{object:l.currentTarget.value}:null),children:[_("option",{value:"",children:n&&"minimum"in n?"A box":"Choose an object…"}),o.map(l=>_("option",{value:l,selected:n!==null&&"object"in n&&n.object===l,children:l},l))]})]}),_("div",{class:"row",children:[_(Ge,{label:"Click an object",tip:"The next click in the 3D view chooses the object",onClick:()=>t.get()?.isPicking.set(!0)}),_(Ge,{label:"Box",tip:"A box in the world, at first around the chosen object",isOn:n!==null&&"minimum"in n,onClick:a}),n&&_(Ge,{label:"Clear",class:"text",onClick:()=>s(null)})]}),n&&"minimum"in n&&_("p",{class:"hint",children:"Drag the handles in the 3D view: a square moves a face, the ball the box (with Shift up and down)."}),n&&"minimum"in n&&_(CC,{box:n,onChange:s})]})}function AC(n){if(!n)return[[-1,-1,0],[1,1,1]];let[e,t]=n.bounds,i=n.up==="z"?2:1,s=(o,a)=>Number(((e[o]??0)+((t[o]??0)-(e[o]??0))*a).toFixed(3)),r=(o,a)=>[0,1,2].map(l=>s(l,l===i?a:o));return[r(.25,0),r(.75,.5)]}function CC({box:n,onChange:e}){let t=(i,s,r)=>{let o=[...n[i]];o[s]=r,e({...n,[i]:o})};return _("div",{class:"triple",children:["minimum","maximum"].flatMap(i=>["X","Y","Z"].map((s,r)=>_(Mn,{label:`${s} ${i==="minimum"?"from":"to"}`,value:n[i][r]??0,onChange:o=>t(i,r,o),step:.1,digits:3,unit:"m",...i==="minimum"?{maximum:n.maximum[r]??0}:{minimum:n.minimum[r]??0}},i+s)))})}var RC=400;function PC(n,e,t,i){let{studio:s}=Ve(),[r,o]=Pt({answer:null,error:null}),a=JSON.stringify([n,e,t,i]),l=Tt(a);return l.current=a,Gt(()=>{let c=new AbortController,u=setTimeout(()=>{hn.coverage({scene:n,states:e,region:t,toleranceMm:i},c.signal).then(h=>l.current===a&&o({answer:h,error:null}),h=>{c.signal.aborted||o({answer:null,error:h instanceof Error?h.message:String(h)})})},RC);return()=>{clearTimeout(u),c.abort()}},[a,s]),r}function IC({target:n,tolerance:e}){let{studio:t}=Ve(),{oaks:i,scene:s}=Ae(t.document),r=i.filter(l=>!l.isHidden&&t.hasDepth(l.state)),{answer:o,error:a}=PC(s,r.map(({state:l})=>l),n,e);return _(en,{title:"Coverage",testId:"coverage",children:[_(LC,{value:e}),a&&_("p",{class:"problem",role:"alert",children:a}),!o&&!a&&_("p",{class:"hint",children:"Computing…"}),o&&_(FC,{oaks:r,all:i,answer:o}),_(DC,{})]})}function LC({value:n}){let{studio:e}=Ve();return _("div",{class:"row",children:[_(Oi,{label:"Count only errors up to",tip:"A point with a larger error counts as not measured",isOn:n!==null,onChange:t=>e.show({toleranceMm:t?20:null})}),n!==null&&_(Mn,{label:"Tolerance",isLabelled:!1,unit:"mm",value:n,step:1,digits:1,minimum:.1,maximum:1e4,onChange:t=>e.show({toleranceMm:t})})]})}function DC(){let{studio:n,view:e}=Ve(),{paintsCoverage:t}=Ae(n.display),i=Ae(e);return _(xt,{children:[_(Oi,{label:"Paint the surface",tip:"The 3D view shows with the colours of the table what the selected OAK measures of the surface",isOn:t,onChange:s=>n.show({paintsCoverage:s})}),i&&_(NC,{view:i})]})}function NC({view:n}){let{error:e}=Ae(n.painting);return e&&_("p",{class:"problem",role:"alert",children:e})}function FC({oaks:n,all:e,answer:t}){let i=n.flatMap((c,u)=>{let h=t.poses[u];return h?[{key:c.key,oak:c,pose:h}]:[]}),s=i.length>1?[...i,{key:"together",oak:null,pose:t.together}]:i,{outcomes:r}=Ae(Ve().studio.catalog),o=c=>Math.max(...s.map(({pose:u})=>u.lost[c]??0)),l=[...new Set(s.flatMap(({pose:c})=>Object.keys(c.lost)))].sort((c,u)=>o(u)-o(c)).map(c=>({name:c,outcome:r.find(u=>u.name===c)}));return _("div",{class:"scroll-x",children:_("table",{class:"numbers",children:[_("thead",{children:_("tr",{children:[_("td",{}),s.map(({key:c,oak:u})=>u?_("th",{scope:"col","data-tip":u.state.model,children:_(Pc,{index:e.indexOf(u),model:u.state.model,isShort:s.length>2})},c):_("th",{scope:"col","data-tip":"A point counts if one of the OAKs measures it",children:"All"},c))]})}),_("tbody",{children:[_("tr",{children:[_("th",{scope:"row",children:"Visible, %"}),s.map(({key:c,pose:u})=>_("td",{children:sr(u.seen)},c))]}),_("tr",{children:[_("th",{scope:"row",children:[_("span",{class:"swatch",style:{background:on(ya(0))}}),"Measured, %"]}),s.map(({key:c,pose:u})=>_("td",{children:_("b",{children:sr(u.measured)})},c))]}),_("tr",{children:[_("th",{scope:"row","data-tip":"The share of what the camera sees that it measures",children:"Measured of visible, %"}),s.map(({key:c,pose:u})=>_("td",{children:u.seen>0?sr(u.measured/u.seen):"–"},c))]}),_("tr",{children:[_("th",{scope:"row",children:"Median |error|, mm"}),s.map(({key:c,pose:u})=>_("td",{children:rr(u.medianAbsoluteErrorM)},c))]}),l.map(({name:c,outcome:u})=>_("tr",{children:[_("th",{scope:"row","data-tip":u?.documentation,children:[u&&_("span",{class:"swatch",style:{background:on(ya(u.code))}}),vn(c),", %"]}),s.map(({key:h,pose:d})=>_("td",{children:sr(d.lost[c]??0)},h))]},c))]})]})})}var UC=["X","Y","Z"],OC=[{key:"yaw",label:"Yaw",tip:"The turn about the vertical axis; positive to the left"},{key:"pitch",label:"Tilt",tip:"The tilt of the optical axis; positive looks down"},{key:"roll",label:"Roll",tip:"The turn about the optical axis; positive to the right"}];function _x(){let{studio:n,view:e}=Ve(),t=Ae(n.scene),i=Fn(Ae(n.document));if(!i)return null;let s=t?.up??"z",{pose:r}=i.state,o=ds(r.quaternion,s),a=(u,h)=>n.change(`position${u}`,d=>{let f=[...d.pose.position];return f[u]=h,{...d,pose:{...d.pose,position:f}}}),l=(u,h)=>n.change(u,d=>({...d,pose:{...d.pose,quaternion:hc({...ds(d.pose.quaternion,s),[u]:h},s)}}));return _(en,{title:"Pose",actions:_(xt,{children:[_(Ge,{icon:"camera",label:"Look from the OAK",onClick:()=>e.get()?.lookThrough()}),_(Ge,{icon:"reset",label:"Put it where it was at first",onClick:()=>t&&n.change("pose",u=>({...u,pose:t.pose}))})]}),children:_("div",{class:"triple",children:[UC.map((u,h)=>_(Mn,{label:u,value:r.position[h]??0,onChange:d=>a(h,d),step:.05,digits:3,unit:"m",testId:`position-${u.toLowerCase()}`},u)),OC.map(({key:u,label:h,tip:d})=>_(Mn,{label:h,tip:d,value:o[u],onChange:f=>l(u,f),step:1,digits:2,minimum:u==="pitch"?-90:-360,maximum:u==="pitch"?90:360,unit:"°"},u))]})})}var kC=.05,BC=2,Np=["none","truth","measurement","both"];function xx(n,e){let t=i=>{let{target:s}=i,r=s instanceof HTMLElement&&s.matches("input:not([type=checkbox]), select, textarea");if(zC(n,i)||r||document.querySelector("dialog[open]"))return;(s instanceof HTMLCanvasElement&&GC(n,i)||VC(n,i,e))&&i.preventDefault()};return addEventListener("keydown",t),()=>removeEventListener("keydown",t)}function zC({studio:n},e){if(!(e.ctrlKey||e.metaKey)||e.altKey)return!1;let t=e.key.toLowerCase();return t!=="z"&&t!=="y"?!1:(e.preventDefault(),document.activeElement instanceof HTMLInputElement&&document.activeElement.blur(),t==="y"||e.shiftKey?n.document.redo():n.document.undo(),!0)}function VC(n,e,t){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let{studio:i}=n,s=n.view.get(),r=i.display.get(),o=c=>s?.gizmo.set(s.gizmo.get()===c?"none":c),l={"?":t,1:()=>i.show({showLeft:!r.showLeft}),2:()=>i.show({showRight:!r.showRight}),g:()=>o("translate"),r:()=>o("rotate"),p:()=>i.show({cloud:Np[(Np.indexOf(r.cloud)+1)%Np.length]??"none"}),c:()=>s?.lookThrough(),f:()=>s?.setRiding(!s.isRiding.get()),"[":()=>vx(n,-1),"]":()=>vx(n,1),Home:()=>s?.home(),Escape:()=>{i.hover.set(null),s?.isPicking.set(!1),s?.setRiding(!1)}}[e.key];return l?.(),l!==void 0}function vx({studio:n},e){let t=n.document.get(),i=t.oaks.findIndex(({key:r})=>r===t.selected),s=t.oaks[(i+e+t.oaks.length)%t.oaks.length];s&&n.document.set({...t,selected:s.key})}function GC({studio:n},e){if(e.ctrlKey||e.metaKey||!Fn(n.document.get()))return!1;let t=n.scene.get()?.up??"z",i=kC*(e.shiftKey?.1:1),s=BC*(e.shiftKey?.1:1),r={ArrowUp:[i,0,0],ArrowDown:[-i,0,0],ArrowLeft:[0,i,0],ArrowRight:[0,-i,0],PageUp:[0,0,i],PageDown:[0,0,-i]},o={ArrowUp:{pitch:-s},ArrowDown:{pitch:s},ArrowLeft:{yaw:s},ArrowRight:{yaw:-s}},[a,l]=[r[e.key],o[e.key]];return(e.altKey?!l:!a)?!1:(n.change("keys",c=>({...c,pose:e.altKey?fc(c.pose,l??{},t):dc(c.pose,a??[0,0,0],t)})),!0)}var yx=350;function bx(){let[n,e]=Pt(null),t=Tt(null);if(Gt(()=>{let r=0,o=(h,d)=>{clearTimeout(r);let f=h.target instanceof Element?h.target.closest("[data-tip]"):null;f?r=window.setTimeout(()=>e(f),d):e(null)},a=()=>{clearTimeout(r),e(null)},l=h=>o(h,yx),c=h=>{h.target instanceof Element&&h.target.matches(":focus-visible")&&o(h,yx)},u=h=>h.key==="Escape"&&a();return document.addEventListener("pointerover",l),document.addEventListener("pointerdown",a),document.addEventListener("focusin",c),document.addEventListener("focusout",a),document.addEventListener("keydown",u),()=>{a(),document.removeEventListener("pointerover",l),document.removeEventListener("pointerdown",a),document.removeEventListener("focusin",c),document.removeEventListener("focusout",a),document.removeEventListener("keydown",u)}},[]),hs(()=>{let r=t.current;if(!(!n||!r))return HC(r,n),n.setAttribute("aria-describedby",r.id),()=>n.removeAttribute("aria-describedby")},[n]),!n?.dataset.tip)return null;let[i,...s]=n.dataset.tip.split(`
`);return _("div",{ref:t,id:"tooltip",role:"tooltip",class:"tooltip",children:[_("p",{children:i}),s.map(r=>_("p",{class:"fact",children:r},r))]})}function HC(n,e){let t=e.getBoundingClientRect(),{width:i,height:s}=n.getBoundingClientRect(),r=e.closest(".side");if(r){let c=r.getBoundingClientRect(),u=r.classList.contains("left");n.style.left=`${u?c.right+6:c.left-i-6}px`,n.style.top=`${Math.max(8,Math.min(t.top,innerHeight-s-8))}px`;return}let o=Math.max(8,Math.min(t.left,innerWidth-i-8)),a=t.bottom+6,l=a+s<innerHeight-8?a:Math.max(8,t.top-s-6);n.style.left=`${o}px`,n.style.top=`${l}px`}function Sx({icon:n,label:e,children:t,testId:i}){let[s,r]=Pt(!1),o=Tt(null),a=Tt(null),l=()=>r(!1);return Gt(()=>{if(!s)return;let u=h=>{h.target instanceof Node&&!o.current?.contains(h.target)&&l()};return document.addEventListener("pointerdown",u),o.current?.querySelector('[role="menuitem"]')?.focus(),()=>document.removeEventListener("pointerdown",u)},[s]),_("div",{class:"menu-root",ref:o,onKeyDown:u=>{if(u.key==="Escape"&&(l(),a.current?.focus(),u.stopPropagation()),u.key!=="ArrowDown"&&u.key!=="ArrowUp")return;u.preventDefault();let h=[...o.current?.querySelectorAll('[role="menuitem"]')??[]],f=(h.indexOf(document.activeElement)+(u.key==="ArrowDown"?1:-1)+h.length)%h.length;h[f]?.focus()},children:[_("button",{ref:a,type:"button",class:"button","aria-haspopup":"menu","aria-expanded":s,"data-testid":i,onClick:()=>r(!s),children:[_(rc,{name:n}),_("span",{children:e})]}),s&&_("div",{class:"menu",role:"menu","aria-label":e,children:t(l)})]})}async function Mx(n){let e=[...n.querySelectorAll(".panel")],t=e[0]?.querySelector("canvas"),i=e[0]?.parentElement;if(!t||!i||t.clientWidth===0)return null;let s=Math.max(1,t.width/t.clientWidth),r=e.map(f=>f.getBoundingClientRect()),o=Math.min(...r.map(f=>f.left))-10,a=Math.min(...r.map(f=>f.top))-10,l=Math.max(...r.map(f=>f.right))+10,c=Math.max(...r.map(f=>f.bottom))+10,u=new OffscreenCanvas(Math.round((l-o)*s),Math.round((c-a)*s)),h=u.getContext("2d");if(!h)return null;let d=getComputedStyle(n.documentElement);h.scale(s,s),h.translate(-o,-a),h.fillStyle=d.getPropertyValue("--page"),h.fillRect(o,a,l-o,c-a);for(let f of e)WC(h,f,d);return u.convertToBlob({type:"image/png"})}function WC(n,e,t){let i=e.querySelector("figcaption")?.getBoundingClientRect();if(i){let s=["panel-title","panel-oak","panel-fact"].map(r=>e.querySelector(`.${r}`)?.textContent).filter(Boolean);n.fillStyle=t.getPropertyValue("--text"),n.font=`${t.fontSize} system-ui, sans-serif`,n.textBaseline="middle",n.fillText(s.join("  "),i.left,i.top+i.height/2,i.width)}for(let s of e.querySelectorAll("canvas")){let{x:r,y:o,width:a,height:l}=s.getBoundingClientRect();n.save();let c=s.closest(".wiped"),u=c?Number.parseFloat(/([\d.]+)%/.exec(c.style.clipPath)?.[1]??"0")/100*a:0;n.beginPath(),n.rect(r+u,o,a-u,l),n.clip(),n.imageSmoothingEnabled=!1,n.drawImage(s,r,o,a,l),n.restore()}}var XC=[{title:"Asset (USD)",what:{what:"asset",format:"usda"}},{title:"Asset (USDZ)",what:{what:"asset",format:"usdz"}},{title:"Statistics (JSON)",what:{what:"statistics",format:"json"}},{title:"Statistics (CSV)",what:{what:"statistics",format:"csv"}},{title:"Parameters (TOML)",what:{what:"parameters"}}],qC=[{title:"Command line…",what:{what:"command"}},{title:"Python…",what:{what:"python"}}];async function wx(n,e){let t=n.document.get(),i=Fn(t),s=i&&ui(n.catalog.get(),i.state);if(!i||!s)return null;let r=yo.find(({size:c})=>c===n.display.get().fullSize)?.limit??null,o=c=>({state:c,size:wd(ui(n.catalog.get(),c)?.resolution??[1,1],r)}),a=t.oaks.filter(c=>c.key!==i.key&&!c.isHidden&&n.hasDepth(c.state)),l=e.what==="statistics"?{region:t.region,others:a.map(({state:c})=>o(c))}:{};try{return await hn.export({...e,...l,scene:t.scene,...o(i.state)})}catch(c){return n.report("The export",c),null}}function Tx(n,e){let t=URL.createObjectURL(e),i=document.createElement("a");i.href=t,i.download=n,i.click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}async function YC(n){let e=await Mx(document);e?Tx("oaktwin-images.png",e):n.notify("warning","No image is shown.")}var Ex="The exact values; lengths are metres as 32-bit floating-point numbers";function $C(n){return`${n.length<=4?n.toUpperCase():vn(n)} (ZIP)`}function Ax(){let{studio:n}=Ve(),e=Ae(n.display),[t,i]=Pt(null),s=e.wipe?[e.wipe.left,e.wipe.right]:e.panels,r=Ui.filter(({kind:l})=>s.includes(l)),o=async l=>{let c=await wx(n,l);c&&(Tx(c.name,c.file),c.findings.length&&n.notify("note",`${c.name} is saved.`,c.findings))},a=async(l,c)=>{let u=await wx(n,c);u&&i({title:l.replace("…",""),text:await u.file.text()})};return _(xt,{children:[_(Sx,{icon:"download",label:"Export",testId:"export",children:l=>{let c=(u,h,d)=>_("button",{type:"button",role:"menuitem",class:"menu-item","data-tip":d,onClick:()=>{l(),h()},children:u},u);return _(xt,{children:[_("p",{class:"menu-head",children:"Reproduce this state"}),qC.map(({title:u,what:h})=>c(u,()=>{a(u,h)})),_("p",{class:"menu-head",children:"Files"}),XC.map(({title:u,what:h})=>c(u,()=>{o(h)})),_("p",{class:"menu-head",children:"Robots and simulators"}),n.catalog.get().robotFormats.map(({name:u,help:h})=>c($C(u),()=>{o({what:"robot",format:u})},h)),_("p",{class:"menu-head",children:"Images"}),c("As shown (PNG)",()=>{YC(n)}),r.flatMap(({kind:u,title:h,images:[d]})=>d===void 0?[]:u==="error"?[c(`${h} (NumPy)`,()=>{o({what:"error"})},Ex)]:[c(`${h} (PNG)`,()=>{o({what:"image",image:d,format:"png"})}),c(`${h} (NumPy)`,()=>{o({what:"image",image:d,format:"npy"})},Ex)])]})}}),t&&_(ZC,{title:t.title,text:t.text,onClose:()=>i(null)})]})}function ZC({title:n,text:e,onClose:t}){let{studio:i}=Ve(),[s,r]=Pt(!1);return _(ac,{title:n,onClose:t,children:[_("pre",{class:"code",tabIndex:0,"data-testid":"snippet",children:e}),_("div",{class:"row spread",children:_(Ge,{icon:"copy",label:s?"Copied":"Copy",isNamed:!0,onClick:()=>navigator.clipboard.writeText(e).then(()=>r(!0),a=>i.report("Copying",a)),class:"primary"})})]})}var KC={auto:"dark",dark:"light",light:"auto"};function Cx({onHelp:n}){let{studio:e}=Ve(),t=Ae(e.scene),i=Ae(e.display),s=Ae(e.catalog);Ae(e.document);let r=Tt(null),o=()=>navigator.clipboard.writeText(e.link()).then(()=>e.notify("note","The link is in the clipboard. It restores this state."),l=>e.report("Copying the link",l)),a=()=>e.document.commit("scene",l=>({...l,scene:s.scene,target:null}));return _("header",{class:"top-bar",children:[_(Ge,{icon:"left",label:"Controls (1)",isOn:i.showLeft,onClick:()=>e.show({showLeft:!i.showLeft})}),_("h1",{children:[_("b",{children:"oaktwin"})," studio"]}),_("div",{class:"scene-name",children:[_("span",{"data-testid":"scene",children:t?.name??"Loading…"}),t&&_("span",{class:"detail",children:[t.triangles.toLocaleString("en")," triangles"]})]}),_(Ge,{icon:"open",label:"Open…",isNamed:!0,tip:"Open a scene or a calibration; or drop its file onto the page",onClick:()=>r.current?.click()}),_("input",{ref:r,type:"file",hidden:!0,multiple:!0,"data-testid":"file",onChange:l=>{sc(e,[...l.currentTarget.files??[]]),l.currentTarget.value=""}}),t&&t.id!==s.scene&&_(Ge,{label:"First scene",class:"text",onClick:a}),_("span",{class:"spring"}),_(JC,{}),_(Ge,{icon:"undo",label:"Undo (Ctrl+Z)",isDisabled:!e.document.canUndo,onClick:()=>e.document.undo(),testId:"undo"}),_(Ge,{icon:"redo",label:"Redo (Ctrl+Shift+Z)",isDisabled:!e.document.canRedo,onClick:()=>e.document.redo(),testId:"redo"}),_(Ax,{}),_(Ge,{icon:"link",label:"Copy a link to this state",onClick:o,testId:"link"}),_(Ge,{icon:"theme",label:`Theme: ${i.theme}`,onClick:()=>e.show({theme:KC[i.theme]}),testId:"theme"}),_(Ge,{icon:"help",label:"Keys and help (?)",onClick:n,testId:"help"}),_(Ge,{icon:"right",label:"Numbers (2)",isOn:i.showRight,onClick:()=>e.show({showRight:!i.showRight})})]})}function JC(){let{studio:n}=Ve(),e=Ae(n.connection),t={open:"Connected",connecting:"Connecting…",lost:"No connection; trying again…"}[e];return _("span",{class:`connection ${e}`,role:"status","data-testid":"connection",children:[_("span",{class:"dot-small"}),e!=="open"&&t,e==="open"&&_("span",{class:"sr-only",children:t})]})}function Rx(n,e){let t=e.trim();if(n.type==="boolean")return t==="true"||t==="false"?{text:t}:{problem:"Enter true or false."};if(n.choices)return n.choices.includes(t)?{text:t}:{problem:`Choose one of ${n.choices.join(", ")}.`};if(n.type==="string")return{text:t};let i=Number(t.replace(",","."));if(t===""||!Number.isFinite(i))return{problem:"Enter a number."};if(n.type==="integer"&&!Number.isInteger(i))return{problem:"Enter a whole number."};let{minimum:s,maximum:r,step:o}=n;return o!==null&&(i-(s??0))%o!==0?{problem:`Enter ${Kh(n)}.`}:s!==null&&i<s||r!==null&&i>r?{problem:`Enter ${Kh(n)}.`}:{text:t.replace(",",".")}}function Kh({type:n,choices:e,minimum:t,maximum:i,step:s,unit:r}){let o=t!==null&&t>0&&t<1e-300;if(n==="boolean")return"true or false";if(e)return e.join(", ");let a=r?` ${r}`:"";return s!==null&&t!==null&&i!==null?`${t}, ${t+s}, … ${i}${a}`:o?i===null?`more than 0${a}`:`more than 0, at most ${i}${a}`:t!==null&&i!==null?`${t} to ${i}${a}`:t!==null?`at least ${t}${a}`:i!==null?`at most ${i}${a}`:`any number${a}`}var Zh=4;function Px(n,e,t=1){if(n.type!=="number"&&n.type!=="integer"||n.choices||!Number.isFinite(e))return null;if(n.typical){let[u,h]=[Math.min(n.typical[0],e),Math.max(n.typical[1],e)];return{from:u,to:h,step:n.step??(n.type==="integer"?1:10**Math.floor(Math.log10((h-u)/200)))}}let i=(n.minimum??Math.min(0,Zh*e))*t,s=(n.maximum??Math.max(0,Zh*e))*t,r=Math.abs(e-i),a=r>0&&s-i>3*Zh*r?Number((i+Zh*r).toPrecision(2)):s;if(a<=i)return null;let l=n.step??(n.type==="integer"?1:10**Math.floor(Math.log10((a-i)/200)));return{from:i>0&&i<l?l:i,to:a,step:l}}function Ix(n){let e=new Map;for(let t of n){let i=e.get(t.group);i?i.push(t):e.set(t.group,[t])}return[...e]}function Lx(n){let e=n.indexOf(":");if(e<0)return{name:n,parameters:{}};let t={};for(let i of n.slice(e+1).split(",")){let s=i.indexOf("=");s>0&&(t[i.slice(0,s).trim()]=i.slice(s+1).trim())}return{name:n.slice(0,e),parameters:t}}function Dx({name:n,parameters:e}){let t=Object.entries(e).map(([i,s])=>`${i}=${s}`);return t.length?`${n}:${t.join(",")}`:n}function ua({parameter:n,value:e,fallback:t,problem:i,onChange:s,reach:r=1}){let{name:o,isEstimate:a}=n,l=e??jC(t),c=e!==void 0&&e!==t,u=h=>{let d=Rx(n,h);return"problem"in d?d.problem:(s(d.text===t?void 0:d.text),null)};return _("div",{class:`parameter ${c?"changed":""}`,"data-parameter":o,"data-tip":eR(n,t),children:[_("div",{class:"parameter-head",children:[_("span",{class:"name",children:vn(o)}),a&&_("span",{class:"badge","data-tip":"The default is an estimate: no source gives it",children:"estimate"}),c&&_(Ge,{icon:"reset",label:`Reset ${vn(o)} to ${t}`,class:"small",onClick:()=>s(void 0)})]}),_(QC,{parameter:n,shown:l,fallback:t,problem:i,reach:r,onText:u})]})}function QC({parameter:n,shown:e,fallback:t,problem:i,reach:s,onText:r}){let o=vn(n.name);if(n.type==="boolean")return _("label",{class:"switch",children:[_("input",{type:"checkbox",role:"switch","aria-label":o,checked:e==="true",onChange:u=>r(String(u.currentTarget.checked))}),_("span",{children:e==="true"?"on":"off"}),i&&_("span",{class:"problem",role:"alert",children:i})]});if(n.choices)return _("label",{class:"field",children:[_("span",{class:"sr-only",children:o}),_("select",{value:e,onChange:u=>r(u.currentTarget.value),children:n.choices.map(u=>_("option",{value:u,selected:u===e,children:u},u))}),i&&_("span",{class:"problem",role:"alert",children:i})]});let a=Px(n,Number(t),s),l=a?.step??(n.type==="integer"?1:.01),c=u=>{let h=n.type==="integer"?Math.sign(u)*l:u*l;r(String(Number((Number(e)+h).toPrecision(9))))};return _("div",{class:"slide",children:[a&&_("input",{type:"range","aria-label":o,min:a.from,max:a.to,step:a.step,value:e,onInput:u=>r(u.currentTarget.value)}),n.type==="string"?_(oc,{label:o,isLabelled:!1,text:e,onText:r,unit:n.unit,problem:i}):_(oc,{label:o,isLabelled:!1,text:e,onText:r,onStep:c,unit:n.unit,problem:i})]})}function jC(n){let e=Number(n);return n.length>8&&Number.isFinite(e)?String(Number(e.toPrecision(6))):n}function eR(n,e){let t=n.unit?` ${n.unit}`:"",i=n.type==="string"&&!n.choices;return[`${n.name}: ${n.documentation}`,...i?[]:[`Range: ${Kh(n)}`],`Default: ${e}${t}`,`Source: ${n.isEstimate?"estimate":n.source}`].join(`
`)}function Nx({filters:n,value:e,ran:t,problem:i,onChange:s}){let r=(e??t).map(Lx),o=(l,c)=>s(l,c.map(Dx)),a=(l,c)=>{let u=r[l];u&&o("order",r.toSpliced(l,1).toSpliced(l+c,0,u))};return _("div",{class:"filters",children:[_("ol",{children:r.map((l,c)=>_("li",{class:"filter",children:[_("div",{class:"parameter-head",children:[_("span",{class:"name",children:vn(l.name)}),_(Ge,{icon:"up",label:`Move ${l.name} up`,class:"small",isDisabled:c===0,onClick:()=>a(c,-1)}),_(Ge,{icon:"down",label:`Move ${l.name} down`,class:"small",isDisabled:c===r.length-1,onClick:()=>a(c,1)}),_(Ge,{icon:"close",label:`Remove ${l.name}`,class:"small",onClick:()=>o("remove filter",r.toSpliced(c,1))})]}),_(tR,{use:l,filter:n.find(({name:u})=>u===l.name),onChange:u=>o(`filter ${c} ${l.name}`,r.with(c,u))})]},`${l.name}${c}`))}),r.length===0&&_("p",{class:"hint",children:"No filter runs."}),i&&_("p",{class:"problem",role:"alert",children:i}),_("div",{class:"row",children:[_("select",{"aria-label":"Add a filter",value:"","data-testid":"add-filter",onChange:l=>{o("add filter",[...r,{name:l.currentTarget.value,parameters:{}}]),l.currentTarget.value=""},children:[_("option",{value:"",children:"Add a filter…"}),n.map(({name:l})=>_("option",{value:l,children:vn(l)},l))]}),e!==null&&_(Ge,{icon:"reset",label:"Use the preset's filters",onClick:()=>s("filters",null)})]})]})}function tR({use:n,filter:e,onChange:t}){if(!e)return null;let i=(s,r)=>{let{[s]:o,...a}=n.parameters;t({...n,parameters:r===void 0?a:{...a,[s]:r}})};return _("div",{class:"filter-parameters",children:e.parameters.map(s=>_(ua,{parameter:s,value:n.parameters[s.name],fallback:s.default,problem:void 0,onChange:r=>i(s.name,r)},s.name))})}var nR=.1,iR=4294967295,Fp="population";function Fx({state:n,problem:e}){let{studio:t}=Ve(),i=(s,r)=>t.change(s,o=>({...o,...r}));return _(en,{title:"Noise and unit",children:[_(Up,{label:"Noise seed",tip:"Images with the same seed have the same noise",another:"Another seed",value:n.seed,onChange:s=>i("seed",{seed:s}),testId:"seed"}),_(sR,{state:n,problem:e}),_(Oi,{label:"Calibration error",tip:"A random error of the unit's calibration, which biases its disparity, instead of none",isOn:n.deviceSeed!==null,onChange:s=>i("unit",{deviceSeed:s?1:null})}),n.deviceSeed!==null&&_(Up,{label:"Seed of the error",tip:"Each number is another error",another:"Another error",value:n.deviceSeed,onChange:s=>i("deviceSeed",{deviceSeed:s})})]})}function sR({state:n,problem:e}){let{studio:t}=Ve(),i=Ae(t.calibrations),s=n.populationSeed!==null?Fp:n.calibration??"",r=l=>t.change("device",c=>{let u=l===Fp;return{...c,calibration:u?null:l||null,populationSeed:u?c.populationSeed??1:null}}),o=[...i.values()].map(({id:l,name:c})=>({value:l,title:c})),a=n.calibration!==null&&!i.has(n.calibration);return _(xt,{children:[_(hi,{label:"Cameras",testId:"device",value:s,options:[{value:"",title:"Nominal"},{value:Fp,title:"A unit of the population"},...o,...a&&n.calibration!==null?[{value:n.calibration,title:"A dropped calibration"}]:[]],onChange:r}),n.populationSeed!==null&&_(Up,{label:"Unit",tip:"Each number is another device: focal lengths, principal points, distortion and poses differ as those of factory calibrations do",another:"Another unit",value:n.populationSeed,onChange:l=>t.change("populationSeed",c=>({...c,populationSeed:l})),problem:e("populationSeed"),testId:"population-seed"}),i.size===0&&_("p",{class:"hint",children:"Drop a device's calibration file here to model that device."})]})}function Up({label:n,tip:e,another:t,value:i,onChange:s,problem:r,testId:o}){return _("div",{class:"row end",children:[_(Mn,{label:n,tip:e,value:i,onChange:a=>s(Math.round(a)),step:1,digits:0,minimum:0,maximum:iR,problem:r,...o===void 0?{}:{testId:o}}),_(Ge,{icon:"dice",label:t,onClick:()=>s(Math.floor(Math.random()*1e5))})]})}function Ux({state:n,problem:e}){let{studio:t}=Ve(),{drift:i}=Ae(t.catalog),s=(o,a)=>t.change(`drift ${o}`,l=>{let{[o]:c,...u}=l.drift;return{...l,drift:a===void 0?u:{...u,[o]:a}}}),r=Object.keys(n.drift).length;return _(en,{title:"Drift",testId:"drift",isOpen:r>0,actions:r>0&&_(Ge,{label:"Reset",class:"text",onClick:()=>t.change("drift",o=>({...o,drift:{}}))}),children:[_("p",{class:"hint",children:"How the stereo pair changed since its calibration: a rotation of the right camera, or the growth of the baseline or of the focal lengths."}),i.map(o=>_(ua,{parameter:o,value:n.drift[o.name],fallback:o.default,problem:e(`drift.${o.name}`),onChange:a=>s(o.name,a),reach:nR},o.name))]})}function Ox(){let{studio:n}=Ve(),e=rR(),t=Ae(n.catalog),i=Ae(n.rejections).get(e?.key??""),s=Ps(n.frames,h=>JSON.stringify(h.get(e?.key??"")?.header.filters??[])),r=Ir(()=>JSON.parse(s),[s]);if(!e)return null;let{state:o}=e,a=ui(t,o),l=Sd(t,o);if(!a)return _("p",{class:"hint pad",children:[o.model," has no depth sensor. Choose another model."]});let c=h=>i?.field===h?i.error:void 0,u=i?.field==="filters"||i?.field?.startsWith("drift.")||l?.parameters.some(({name:h})=>h===i?.field);return _(xt,{children:[_(aR,{state:o,sensor:a,problem:u?void 0:i?.error}),_(Fx,{state:o,problem:c}),a.kind==="stereo"&&_(Ux,{state:o,problem:c}),_(en,{title:"Filters",isOpen:o.filters!==null,children:_(Nx,{filters:t.filters,value:o.filters,ran:r,problem:c("filters"),onChange:(h,d)=>n.change(h,f=>({...f,filters:d}))})}),l&&_(uR,{parameters:l.parameters,state:o,problem:c},l.name)]})}function rR(){let{studio:n}=Ve(),e=Tt(void 0);return Ps(n.document,t=>{let i=Fn(t),{current:s}=e;return i&&s&&i.key===s.key&&oR(i.state,s.state)?s:(e.current=i,i)})}function oR(n,e){return Object.keys(n).every(t=>t==="pose"||n[t]===e[t])}function aR({state:n,sensor:e,problem:t}){let{studio:i}=Ve(),s=Ae(i.catalog),r=_i(s,n.model),o=Sd(s,n),a=(l,c)=>i.change(l,u=>({...u,...c}));return _(en,{title:"Sensor",children:[(r?.depthSensors.length??0)>1&&_(hi,{label:"Depth sensor",value:n.sensor,options:(r?.depthSensors??[]).map(({id:l})=>({value:l,title:vn(l)})),onChange:l=>{let c=r?.depthSensors.find(u=>u.id===l);a("sensor",{sensor:l,engine:c?.engines[0]??"",preset:null,parameters:{},filters:null})}}),_(hi,{label:"Engine",testId:"engine",value:n.engine,options:e.engines.map(l=>({value:l,title:vn(l)})),onChange:l=>a("engine",{engine:l,parameters:{}})}),o&&_("p",{class:"hint",children:o.help}),e.presets.length>0&&_(hi,{label:"Preset",value:n.preset??"",options:[{value:"",title:"None"},...e.presets.map(l=>({value:l,title:vn(l)}))],onChange:l=>a("preset",{preset:l||null})}),e.kind==="stereo"&&_(Oi,{label:"Extended disparity",tip:"Doubles the disparity range, for near surfaces",isOn:n.extendedDisparity,onChange:l=>a("extended",{extendedDisparity:l})}),e.kind==="stereo"&&_(Oi,{label:"Fisheye lenses",tip:"The optics of the left and right cameras of wide models: fisheye instead of pinhole",isOn:n.lens==="fisheye",onChange:l=>a("lens",{lens:l?"fisheye":"pinhole"})}),e.kind==="stereo"&&_(cR,{state:n,isSeen:o?lR(o):!1,hasProjector:r?.hasProjector??!1}),t&&_("p",{class:"problem",role:"alert",children:t})]})}function lR({isMatcher:n,parameters:e}){return n||e.some(({name:t})=>t==="dotContrast")}function cR({state:n,isSeen:e,hasProjector:t}){let{studio:i}=Ve(),s=n.ambient===0;return _(xt,{children:[_("div",{class:"row",children:[_("span",{class:"name",id:"light",children:"Light"}),_("div",{class:"segments",role:"group","aria-labelledby":"light",children:[_(Ge,{label:"Day",isOn:!s,onClick:()=>i.change("ambient",r=>({...r,ambient:1}))}),_(Ge,{label:"Night",isOn:s,onClick:()=>i.change("ambient",r=>({...r,ambient:0}))})]})]}),_("div",{class:"pair",children:[_(Mn,{label:"Ambient",tip:"The brightness of the scene's own light in the infrared images; 1 is that of the scene",value:n.ambient,onChange:r=>i.change("ambient",o=>({...o,ambient:r})),step:.1,digits:3,minimum:0,maximum:100}),(t||n.projector>0)&&_(Mn,{label:"Projector",tip:"The brightness of the dot projector; 0 is off, 1 its full power",value:n.projector,onChange:r=>i.change("projector",o=>({...o,projector:r})),step:.1,digits:3,minimum:0,maximum:100})]}),!e&&_("p",{class:"hint",children:"The light changes the left and right images. This engine does not depend on them."})]})}function uR({parameters:n,state:e,problem:t}){let{studio:i,defaults:s}=Ve();Ae(s);let r=Object.keys(e.parameters).length,o=(a,l)=>i.change(`parameter ${a}`,c=>{let{[a]:u,...h}=c.parameters;return{...c,parameters:l===void 0?h:{...h,[a]:l}}});return _(xt,{children:[_("div",{class:"divider",children:[_("h2",{children:"Parameters"}),r>0&&_(Ge,{label:`Reset all ${r}`,class:"text",testId:"reset-all",onClick:()=>i.change("reset",a=>({...a,parameters:{}}))})]}),Ix(n).map(([a,l])=>_(en,{title:vn(a),testId:"parameter-group",children:l.map(c=>_(ua,{parameter:c,value:e.parameters[c.name],fallback:s.of(e,c),problem:t(c.name),onChange:u=>o(c.name,u)},c.name))},a))]})}var hR=[{value:"none",title:"No points"},{value:"truth",title:"True points"},{value:"measurement",title:"Measured points"},{value:"both",title:"True and measured"}],dR=[{value:"error",title:"by error"},{value:"depth",title:"by depth"},{value:"reason",title:"by reason"},{value:"oak",title:"by OAK"}];function kx(){let n=Ve(),{studio:e,view:t}=n,i=Tt(null);return Gt(()=>{if(!i.current)return;let s=new qh(e,i.current);return t.set(s),()=>{t.set(null),s.viewer.close()}},[]),_("section",{class:"view","aria-label":"3D view",children:[_("canvas",{ref:i,tabIndex:0,"data-testid":"view","aria-label":"3D view of the scene. W, A, S, D, Q and E fly; arrow keys move the OAK; question mark lists all keys."}),_(fR,{})]})}function fR(){let{studio:n,view:e}=Ve(),t=Ae(e),i=Ae(n.display),{cloud:s,cloudColor:r}=i;return _(xt,{children:[_("div",{class:"tools top",role:"toolbar","aria-label":"Tools of the 3D view",children:[t&&_(pR,{view:t}),t&&_(mR,{view:t}),_(Ge,{icon:"home",label:"Look at the OAK (Home)",onClick:()=>t?.home()})]}),_("div",{class:"tools layers",role:"toolbar","aria-label":"What the 3D view shows",children:[_(Ge,{label:"Scene",class:"chip",isOn:i.showScene,onClick:()=>n.show({showScene:!i.showScene})}),_(Ge,{label:"Roof",class:"chip",tip:"What is above the OAK, such as a ceiling",isOn:i.showRoof,onClick:()=>n.show({showRoof:!i.showRoof})}),_(Ge,{label:"Cameras",class:"chip",tip:"The fields of view of the cameras",isOn:i.showCameras,onClick:()=>n.show({showCameras:!i.showCameras})}),_(Ge,{label:"Ranges",class:"chip",tip:"The minimum (red), ideal (green) and maximum (orange) distance of the depth sensor",isOn:i.showRanges,onClick:()=>n.show({showRanges:!i.showRanges})}),_(Ge,{label:"Grid",class:"chip",tip:"Squares of one metre",isOn:i.showGrid,onClick:()=>n.show({showGrid:!i.showGrid})}),_(hi,{label:"Point cloud",isLabelled:!1,value:s,options:hR,onChange:o=>n.show({cloud:o}),testId:"cloud"}),s!=="none"&&_(hi,{label:"Colour of the points",isLabelled:!1,value:r,options:dR,onChange:o=>n.show({cloudColor:o})})]}),t&&_(gR,{view:t})]})}function pR({view:n}){let e=Ae(n.gizmo),t=i=>n.gizmo.set(e===i?"none":i);return _(xt,{children:[_(Ge,{icon:"move",label:"Move the OAK (G)",isOn:e==="translate",onClick:()=>t("translate")}),_(Ge,{icon:"turn",label:"Turn the OAK (R)",isOn:e==="rotate",onClick:()=>t("rotate")})]})}function mR({view:n}){let e=Ae(n.isRiding);return _(Ge,{icon:"camera",label:"Fly the OAK: it moves with the view (F)",isOn:e,onClick:()=>n.setRiding(!e)})}function gR({view:n}){let e=Ae(n.detail);return Ae(n.isPicking)?_("div",{class:"note-line",children:"Click an object of the scene. Escape cancels."}):!e||e.shown>=e.of?null:_("div",{class:"note-line",children:[`This view draws ${e.shown.toLocaleString("en")} of ${e.of.toLocaleString("en")} triangles; the images use all. `,_("button",{type:"button",class:"link",onClick:()=>n.loadFullDetail(),children:"Draw all"})]})}function Bx(){let n=Ve(),{studio:e}=n,t=Ae(e.display),[i,s]=Pt(!1);return Gt(()=>xx(n,()=>s(!0)),[]),Gt(()=>{let{theme:r}=t;r==="auto"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=r,n.view.get()?.paintBackground(),n.repaint.update(o=>o+1)},[t.theme]),_("div",{class:`page ${t.showLeft?"":"no-left"} ${t.showRight?"":"no-right"}`,children:[_(Cx,{onHelp:()=>s(!0)}),t.showLeft&&_("aside",{class:"side left","aria-label":"Controls",children:[_(W0,{}),_(_x,{}),_(Ox,{})]}),_(vR,{}),t.showRight&&_(_R,{}),_(H0,{}),_(xR,{}),_(bx,{}),i&&_(tg,{onClose:()=>s(!1)})]})}function _R(){let[n,e]=Pt("inspect");return _("aside",{class:"side right","aria-label":"Numbers",children:[_("div",{class:"tabs",role:"tablist",onKeyDown:s=>{if(s.key!=="ArrowLeft"&&s.key!=="ArrowRight")return;let r=n==="inspect"?"place":"inspect";e(r),document.getElementById(`tab-${r}`)?.focus()},children:[["inspect","Understand"],["place","Place"]].map(([s,r])=>_("button",{type:"button",role:"tab",id:`tab-${s}`,"aria-selected":n===s,tabIndex:n===s?0:-1,"aria-controls":"tab-panel","data-testid":`tab-${s}`,onClick:()=>e(s),children:r},s))}),_("div",{role:"tabpanel",id:"tab-panel","aria-labelledby":`tab-${n}`,children:n==="inspect"?_(G0,{}):_(gx,{})})]})}function vR(){let{studio:n}=Ve(),{split:e}=Ae(n.display),t=Tt(null),i=o=>n.show({split:Math.max(.12,Math.min(.88,o))}),s=o=>{o.preventDefault();let a=t.current?.getBoundingClientRect();if(!a)return;let l=u=>i((u.clientY-a.top)/a.height),c=()=>removeEventListener("pointermove",l);addEventListener("pointermove",l),addEventListener("pointerup",c,{once:!0})},r=o=>{let a={ArrowUp:-.03,ArrowDown:.03}[o.key];a!==void 0&&(o.preventDefault(),i(e+a))};return _("main",{class:"middle",ref:t,style:{gridTemplateRows:`minmax(0, ${e}fr) 7px minmax(0, ${1-e}fr)`},children:[_(kx,{}),_("div",{class:"splitter",role:"separator","aria-orientation":"horizontal","aria-label":"Share of the 3D view","aria-valuenow":Math.round(e*100),"aria-valuemin":12,"aria-valuemax":88,tabIndex:0,onPointerDown:s,onKeyDown:r}),_(fg,{})]})}function xR(){let{studio:n}=Ve(),[e,t]=Pt(!1);return Gt(()=>{let i=a=>a.dataTransfer?.types.includes("Files")??!1,s=a=>{i(a)&&(a.preventDefault(),t(!0))},r=a=>a.relatedTarget===null&&t(!1),o=a=>{i(a)&&(a.preventDefault(),t(!1),sc(n,[...a.dataTransfer?.files??[]]))};return addEventListener("dragover",s),addEventListener("dragleave",r),addEventListener("drop",o),()=>{removeEventListener("dragover",s),removeEventListener("dragleave",r),removeEventListener("drop",o)}},[n]),e?_("div",{class:"drop",children:[_("p",{children:"Drop a scene or a calibration"}),_("span",{children:"It is read, never stored, and stays on this computer."})]}):null}var yR=1e3;function Vx({title:n,text:e}){return _("div",{class:"message",role:"alert",children:[_("h1",{children:n}),_("p",{children:e})]})}function bR(){return document.createElement("canvas").getContext("webgl2")!==null}async function SR(n){for(;;)try{let e=await hn.catalog();return new ic(e,await hn.scene(e.scene))}catch(e){Vl(_(Vx,{title:"No server yet",text:`${e instanceof Error?e.message:String(e)} The page tries again.`}),n),await new Promise(t=>setTimeout(t,yR))}}async function MR(n){if(!bR()){Vl(_(Vx,{title:"WebGL 2 is missing",text:"This page draws with WebGL 2, which this browser does not offer. Enable hardware acceleration in its settings, update it, or use a current Firefox, Chrome, Edge or Safari. The command line does all of this without a browser: oaktwin render --help."}),n);return}let e=await SR(n),t=new Bt(0),i=new $l,s=new tc(e),r=new Wl(()=>t.update(l=>l+1)),o={studio:e,defaults:i,painter:r,repaint:t,view:new Bt(null),signals:{painted:0}};e.document.subscribe(()=>r.keep(e.document.get().oaks.map(({key:l})=>l))),Vl(_(Ad.Provider,{value:o,children:_(Bx,{})}),n);let a=new ec(e,s,i);window.studio={get isIdle(){return a.isIdle&&(o.view.get()?.isIdle??!1)},get painted(){return o.signals.painted},get drawn(){return o.view.get()?.viewer.drawn??0},get received(){return a.received},document:e.document}}var zx=document.getElementById("page");zx&&MR(zx);
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
